#!/usr/bin/env bash
# Prints, in a run folder, minus the strain across between probes 2 and 3 over that along between probes 0 and 1.
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 { x[$3] = $at["x"]; y[$3] = $at["y"]; u[$3] = $at["displacement_x"]; v[$3] = $at["displacement_y"] }
  END { printf "%.12g\n", -(v[3] - v[2]) / (y[3] - y[2]) / ((u[1] - u[0]) / (x[1] - x[0])) }' probes.csv
