#!/usr/bin/env bash
# Error over cost of steps, substeps, safety, integrator, load and forcing iterations, judged by gates.yaml; and
# cost.csv, which needs arithmetic of its own. All of it takes a quarter of an hour of one core.
# usage: cases/verification/cost/run.sh [FRANA [RUNS [OUT [quick]]]]
#        cases/verification/cost/run.sh --summary [OUT]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=cases/common.sh
. "$here/../../common.sh"
code=0
here=$here "$here/../gates.sh" "$@" || code=$?
if [ "${1-}" = --summary ] || [ "${4-}" ] || [ "$code" -gt 1 ]; then exit "$code"; fi
runs=${2:-runs/verification/cost} out=${3:-$here/results}

# cost.csv: each run of the block with its steps, sweeps, counted cost and relative errors
costs() { # costs STUDY FROM: FROM is when the solid becomes elastic, s
  local method level folder
  sed '/^#/d; /^method,level/d' "$runs/$1.csv" | cut -d, -f1,2 | awk '!seen[$0]++' |
    while IFS=, read -r method level; do
      folder=$runs/runs/$1/$(printf '%s\n' "$method" "$level" | tr -c 'A-Za-z0-9._\n' - | paste -sd /)/1
      is_done "$folder" || continue
      printf '%s,%s,%s,' "$1" "$method" "$level"
      awk -v from="$2" -f "$here/cost.awk" "$folder/run.json" "$folder/scene.resolved.yaml" "$folder/series.csv"
    done
}
costed() { # costed STUDY FROM: the same with each quantity's value and relative error
  costs "$@" >"$runs/$1.costs"
  awk -F, -v study="$1" 'FNR == NR { cost[$2 "," $3] = $4 "," $5 "," $6; next } /^#/ { next }
    !at { for (i = 1; i <= NF; i++) k[$i] = i; at = 1; next }
    ($1 "," $2) in cost { print study "," $1 "," $2 "," $k["quantity"] "," $k["value"] "," $k["relative_error"] "," \
      cost[$1 "," $2] }' "$runs/$1.costs" "$runs/$1.csv"
}
# cost.csv and cost.png stand for the studies' own pages and plots, whose seconds are of a machine that did other work
rm -f "$out"/study_*.md "$out"/study_*.png
sed -i '/^# advice on /d' "$out"/study_*.csv
{ echo study,method,level,quantity,value,relative_error,steps,sweeps,counted_s
  costed study_first 0.038403
  costed study_broken 0.038403
  costed study_scatter 0.038403
  costed study_settled 0.033569
  costed study_scatter_settled 0.033569
  costed study_multistep 0.033569
  costed study_hold 0; } >"$out/cost.csv"
if command -v gnuplot >/dev/null; then gnuplot -e "folder = '$out'" "$here/cost.gp"; fi
exit "$code"
