#!/usr/bin/env bash
# Prints, in a run folder, the crack's opening in its middle over p a/E, from the two layers next to the crack.
set -euo pipefail
a=$(awk -F'[][,]' '/^  cracks:/ { in_crack = 1 } in_crack && /- \[/ { x[++n] = $2 } n == 2 { in_crack = 0 }
  END { print (x[2] - x[1]) / 2 }' scene.resolved.yaml)
awk -F, -v a="$a" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR > 2 { u[$3] = $at["displacement_y"] }
  END { printf "%.10g\n", (u[0] - u[1]) / (1e-6 * a) }' probes.csv
