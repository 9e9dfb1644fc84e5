# shellcheck shell=bash
# shellcheck disable=SC2034 # again, known, measured: of cases/common.sh
# What the cases of this folder and of cases/stability share, sourced by bash.
# usage: CASE/run.sh [FRANA [RUNS [OUT [quick]]]]
#        CASE/run.sh --summary [OUT]
# Runs are written to RUNS (default runs/verification/CASE), numbers to OUT (default CASE/results). `quick` leaves out
# runs of minutes. The script exits with 1 if a number misses its tolerance; with another OUT than CASE/results only if
# CASE/results/summary.csv does not have this miss. `--summary` runs nothing: it judges the numbers of OUT's studies and
# of measured.csv again, and writes summary.csv and shown.csv.
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
here=$(cd "$(dirname "${BASH_SOURCE[1]}")" && pwd)
if [ "${1-}" = --summary ]; then
  again=yes frana='' runs='' out=${2:-$here/results} quick='' tables=${2:-$here/results}
else
  again='' frana=$(realpath "${1:-build/frana}") runs=${2:-runs/verification/$(basename "$here")}
  out=${3:-$here/results} quick=${4:-} tables=$runs
  mkdir -p "$runs" "$out"
fi
known=$here/results/summary.csv
[ "$(realpath "$out")" != "$here/results" ] || [ "$quick" ] || known=
[ ! "$quick" ] || measured=$runs/measured.csv
digits=10
summary_begin "$out/$([ "$quick" ] && echo quick || echo summary).csv"

# study NAME: runs a study of this case. Its tables and plots are stored beside the summary.
study() {
  [ ! "$again" ] || return 0
  "$frana" study "$here/$1.yaml" --out "$runs" >"$runs/$1.log" 2>&1 || { cat "$runs/$1.log" >&2; exit 1; }
  [ "$quick" ] || cp "$runs/$1".csv "$runs/$1".md "$runs/$1"*.png "$out" 2>/dev/null || true
}
