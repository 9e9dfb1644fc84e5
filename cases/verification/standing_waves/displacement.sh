#!/usr/bin/env bash
# Displacement at the end over that at the start, in a run folder.
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "displacement_x") at = i } NR == 3 { first = $at } END {
  printf "%.15g\n", $at / first }' probes.csv
