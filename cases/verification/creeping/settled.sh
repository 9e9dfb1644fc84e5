#!/bin/sh
# Prints the wall time (s) of the steps until the permeability stays within 0.1 % of its last value.
# usage: settled.sh, in the run folder
wall=$(sed -n 's/.*"wall_seconds": *\([0-9.e+-]*\).*/\1/p' run.json) \
  setup=$(sed -n 's/.*"setup_seconds": *\([0-9.e+-]*\).*/\1/p' run.json)
awk -F, -v wall="$wall" -v setup="$setup" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR > 2 {
  step[++n] = $at["step"]; k[n] = $at["permeability"] }
  END { s = n; while (s > 1 && k[s - 1] / k[n] < 1.001 && k[s - 1] / k[n] > 0.999) s--
    printf "%.6g\n", (wall - setup) * step[s] / step[n] }' series.csv
