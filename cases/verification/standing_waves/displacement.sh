#!/usr/bin/env bash
# Prints, in a run folder, the displacement at the end over that at the start.
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "displacement_x") at = i } NR == 3 { first = $at } END {
  printf "%.15g\n", $at / first }' probes.csv
