#!/usr/bin/env bash
# What a free body's run has gained that nothing has given it, read from series.csv in the folder where it is called.
# usage: drift.sh momentum|energy MASS
#     momentum   largest change of momentum since the first row after the loads, over that of the motion,
#                sqrt(2 MASS e_kinetic)
#     energy     largest change of e_kinetic + e_strain - work_load since the first row, over their last sum
set -euo pipefail
awk -F, -v what="$1" -v mass="$2" '
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
  $1 ~ /^#/ { next }
  {
    energy = $at["e_kinetic_solid"] + $at["e_strain"] - $at["work_load"]
    if (!begun++) first = energy
    most = abs(energy - first) > most ? abs(energy - first) : most
    if ($at["t"] >= 2.5e-4) {
      if (!free++) for (c = 0; c < 3; c++) p0[c] = $(at["momentum_x"] + c)
      for (c = p = 0; c < 3; c++) p += ($(at["momentum_x"] + c) - p0[c])^2
      drift = sqrt(p) > drift ? sqrt(p) : drift
    }
    kinetic = $at["e_kinetic_solid"]
    last = kinetic + $at["e_strain"]
  }
  function abs(x) { return x < 0 ? -x : x }
  END { printf "%.6g\n", what == "momentum" ? drift/sqrt(2*mass*kinetic) : most/last }' series.csv
