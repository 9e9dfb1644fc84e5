#!/usr/bin/env bash
# bench/start.sh: a row for the demonstration, whose phases add up, and a refusal of wrong options.
#     usage: start.sh FRANA WORK
set -euo pipefail
frana=$(realpath "$1") run=$(cd "$(dirname "$0")/../../.." && pwd)/bench/start.sh work=$2
rm -rf "$work" && mkdir -p "$work" && cd "$work"
fail() { echo "FAILED: $*" >&2; cat out err >&2; exit 1; }
"$run" --frana "$frana" --repeats 1 --ranks 1 --scenes demo >out 2>err || fail "code $?"
# | demo | 1 | launch | solid | bonds | surface | limits, first | again | rest | first | again | to the prompt |
awk -F '|' '
  $2 == " demo " { rows++
    sum = $4 + $5 + $6 + $7 + $9 + $10
    if (NF != 14 || sum <= 0 || (sum - $12) ^ 2 > 0.04 ^ 2 || $13 <= 0) bad = 1 } # each is rounded to 0.01 s
  END { exit rows != 1 || bad }' out || fail "the row"
refuses() {
  local sentence=$1 code=0
  shift
  "$run" "$@" >out 2>err || code=$?
  if [ $code != 2 ] || ! grep -qF -e "$sentence" err; then fail "start.sh $*: code $code"; fi
}
refuses "must be of demo, S3 and plate" --frana "$frana" --scenes "demo S4"
refuses "--repeats 0: must be" --frana "$frana" --repeats 0
refuses "--ranks two: must be" --frana "$frana" --ranks two
refuses "there is no such program" --frana ./missing
refuses "unknown option" --scene demo
