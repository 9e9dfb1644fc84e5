#!/usr/bin/env bash
# Prints, in the folder of the runs, cost.csv: each run of the block with its steps, sweeps and counted cost, and each
# quantity's value and relative error.
set -euo pipefail
costed() { # costed STUDY FROM: FROM is when the solid becomes elastic, s
  local method level folder
  sed '/^#/d; /^method,level/d' "$1.csv" | cut -d, -f1,2 | awk '!seen[$0]++' |
    while IFS=, read -r method level; do
      folder=runs/$1/$(printf '%s\n' "$method" "$level" | tr -c 'A-Za-z0-9._\n' - | paste -sd /)/1
      grep -qs '"status": *"done"' "$folder/run.json" || continue
      printf '%s,%s,%s,' "$1" "$method" "$level"
      awk -v from="$2" -f "$FRANA_STUDY/cost.awk" "$folder/run.json" "$folder/scene.resolved.yaml" "$folder/series.csv"
    done >"$1.costs"
  awk -F, -v study="$1" 'FNR == NR { cost[$2 "," $3] = $4 "," $5 "," $6; next } /^#/ { next }
    !at { for (i = 1; i <= NF; i++) k[$i] = i; at = 1; next }
    ($1 "," $2) in cost { print study "," $1 "," $2 "," $k["quantity"] "," $k["value"] "," $k["relative_error"] "," \
      cost[$1 "," $2] }' "$1.costs" "$1.csv"
}
echo study,method,level,quantity,value,relative_error,steps,sweeps,counted_s
for study in first broken scatter; do costed study_$study 0.038403; done
for study in settled scatter_settled multistep; do costed study_$study 0.033569; done
costed study_hold 0
