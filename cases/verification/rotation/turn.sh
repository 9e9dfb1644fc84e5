#!/bin/sh
# Prints the angular velocity of the line between the two probes at the end, over the shear rate, from probes.csv.
awk -F, '
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR <= 2 { next }
  { p = $at["probe"]
    x[p] = $at["x"] + $at["displacement_x"]; y[p] = $at["y"] + $at["displacement_y"]
    u[p] = $at["velocity_x"]; v[p] = $at["velocity_y"] }
  END { dx = x[0] - x[1]; dy = y[0] - y[1]
    printf "%.10g\n", -(dx * (v[0] - v[1]) - dy * (u[0] - u[1])) / (dx * dx + dy * dy) / (0.15 / 24) }' probes.csv
