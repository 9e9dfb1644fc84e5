#!/usr/bin/env bash
# Runs all cases in full, one after the other. Prints a table of the verdicts at the end, and makes docs/accuracy.md.
# Cases that this build has finished are not run again.
# usage: cases/verification/nightly.sh [FRANA [RUNS [CASE ...]]]      (build/frana, runs/verification, all)
set -euo pipefail
cd "$(dirname "$0")/../.."
frana=$(realpath "${1:-build/frana}") runs=${2:-runs/verification}
shift $(($# < 2 ? $# : 2))
. cases/common.sh
# shellcheck disable=SC2046 # a list
[ $# -gt 0 ] || set -- $(cd cases/verification && ls -d */ | tr -d /)
build=$("$frana" --version)
mkdir -p "$runs"

begun=$SECONDS
for case in "$@"; do
  if [ -f "$runs/$case.done" ] && [ "$(cat "$runs/$case.done")" = "$build" ]; then continue; fi
  printf '%-20s ' "$case"
  since=$SECONDS code=0
  "cases/verification/$case/run.sh" "$frana" "$runs/$case" >"$runs/$case.log" 2>&1 || code=$?
  [ $code -lt 128 ] || exit $code # interrupted
  echo "$((SECONDS - since)) s$([ $code = 0 ] || echo ", left with $code: $runs/$case.log")"
  [ $code -gt 1 ] || echo "$build" >"$runs/$case.done"
done
tools/accuracy.sh

printf '\n%-20s %6s %6s %6s\n' case gates passed missed
bad=0
for case in "$@"; do
  summary=cases/verification/$case/results/summary.csv
  passed=$(grep -c ',yes$' "$summary" || true) missed=$(grep -c ',no$' "$summary" || true)
  state=""
  [ -f "$runs/$case.done" ] || state=" not finished: $runs/$case.log" bad=1
  printf '%-20s %6d %6d %6d%s\n' "$case" $((passed + missed)) "$passed" "$missed" "$state"
  [ "$missed" = 0 ] || { grep ',no$' "$summary" | sed 's/^/    /'; bad=1; }
done
echo "$((SECONDS - begun)) s"
exit $bad
