#!/usr/bin/env bash
# Prints, in a run folder, stress over strain between the two probes, over E.
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR > 2 { x[$3] = $at["x"]; u[$3] = $at["displacement_x"] }
  END { printf "%.12g\n", 1e-8 * (x[1] - x[0]) / (u[1] - u[0]) }' probes.csv
