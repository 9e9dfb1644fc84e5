#!/usr/bin/env bash
# Prints an acceleration of the run `released`, m/s2: acceleration.sh PROBE x|y|z. The only step, of 1e-12 s, begins at
# rest, so its velocity is the acceleration times the step.
awk -F, -v p="$1" -v c="velocity_$2" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 && $1 == 1 && $3 == p { printf "%.15g\n", $at[c] * 1e12 }' released/probes.csv
