#!/usr/bin/env bash
# Prints the longest stable step of an integrator to a thousandth, by bisection between 0.9 and 1.1 of the expected one:
# the longest for which the energy stays below a thousand times that at the start.
# usage: longest.sh INTEGRATOR EXPECTED    in the folder of the runs
set -euo pipefail
grows() {
  rm -rf stability
  "$FRANA" run "$FRANA_STUDY/stability.yaml" --out stability --set stages.swing.integrator="$1" \
    --set stages.swing.time_step="$2" >stability.log 2>&1 || { [ $? = 3 ] && return 0; cat stability.log >&2; exit 1; }
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 { e = $at["e_kinetic_solid"] + $at["e_strain"]; if (!start) start = e }
    END { exit !(e > 1000 * start || e != e) }' stability/series.csv
}
calc() { awk "BEGIN { printf \"%.12g\\n\", $1 }"; }
low=$(calc "0.9 * $2") high=$(calc "1.1 * $2")
! grows "$1" "$low" || { echo 0; exit; }
for _ in 1 2 3 4 5 6 7 8; do
  middle=$(calc "($low + $high) / 2")
  if grows "$1" "$middle"; then high=$middle; else low=$middle; fi
done
echo "$low"
