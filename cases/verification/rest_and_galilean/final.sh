#!/usr/bin/env bash
# Prints a result at the end of the run in this folder. usage: final.sh load|forcing|strain|slip|broken|velocity
#   load, forcing  the largest component, N
#   strain         the bonds' energy, J
#   slip           velocity along x of the sphere's middle minus the fluid's mean velocity, m/s
#   broken         broken bonds
#   velocity       velocity of the fluid, m/s
set -euo pipefail
awk -F, -v what="$1" -v OFMT=%.10g '
  function largest(name,   m, c, x) { for (c = 1; c <= 3; c++) { x = $at[name "_" substr("xyz", c, 1)];
    x = x < 0 ? -x : x; m = x > m ? x : m } return m }
  FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  !/^[0-9]/ { next }
  NR == FNR { middle = $at["velocity_x"]; next }
  { last["load"] = largest("load"); last["forcing"] = largest("forcing"); last["strain"] = $at["e_strain"]
    last["broken"] = $at["bonds_broken"]; last["velocity"] = $at["u_bulk"] }
  END { slip = middle - last["velocity"]; last["slip"] = slip < 0 ? -slip : slip;
    print last[what] }' probes.csv series.csv
