#!/usr/bin/env bash
# Prints how far the effective wall of the flow lies outside the planes, in cells. usage: shift.sh, in the run folder
# The parabola u = G/(2 mu) (h^2/4 - (y - y_c)^2) with rho = nu = 1 through the velocity at the centre of the first cell
# gives the height h. y_c is at 0.3 + offset cells, half a period from the middle of the wall. Outside means that the
# channel is too narrow.
offset=$(sed -n 's/^ *lattice_offset: *\[[^,]*, *\([^,]*\),.*/\1/p' scene.resolved.yaml)
cells=$(sed -n 's/^ *cells: *\[[^,]*, *\([^,]*\),.*/\1/p' scene.resolved.yaml)
gradient=$(awk -F, '!at { for (i = 1; i <= NF; i++) if ($i == "dp") at = i; next } !/^#/ { dp = $at }
  END { printf "%.15g", dp }' series.csv)
awk -F, -v g="$gradient" -v n="$cells" -v q="$offset" 'NR > 2 { u = $7 }
  END { d = 1 / n; from = (0.2 - q) * d; h = 2 * sqrt(2 * u * 4 * d / g + from ^ 2);
    printf "%.9g\n", (1 - 4.6 * d - h) / 2 / d }' fluid_probes.csv
