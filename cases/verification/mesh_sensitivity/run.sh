#!/usr/bin/env bash
# Error of the nonlocal problem against horizon over spacing, spacing, perturbation and wall time, by arrangement.
# usage: cases/verification/mesh_sensitivity/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
source="an independent program, tensor grids"
study study_horizon_grids
for pair in 2:0.0305654 3:0.0167932 4:0.0287768; do
  m=${pair%:*}
  near "lattice, m = $m, relative L2 error" 1 "$(cell study_horizon_grids value lattice "m $m" error_l2)" "${pair#*:}" \
    "$source" 2e-6
done
# rises STUDY METHOD STEP: how often the error rises as m grows in steps of STEP from 2 to 5
rises() {
  for m in $(seq 2 "$3" 5 | sed 's/,/./; s/\(\.[0-9]*[1-9]\)0*$/\1/; s/\.0*$//'); do
    cell "$1" value "$2" "m $m" error_l2
  done | awk 'NR > 1 && $1 > before { n++ } { before = $1 } END { print n + 0 }'
}
# ratio STUDY METHOD STEP: the largest error over the least, m = 3 to 5
ratio() {
  for m in $(seq 3 "$3" 5 | sed 's/,/./; s/\(\.[0-9]*[1-9]\)0*$/\1/; s/\.0*$//'); do
    cell "$1" value "$2" "m $m" error_l2
  done | awk '{ if (NR == 1 || $1 < low) low = $1; if ($1 > high) high = $1 } END { print high / low }'
}
row "lattice: m at which the error rises, of 12 steps of 1/4" 1 "$(rises study_horizon_grids lattice 0.25)" "" \
  "004: non-monotone in m" 3
[ "$quick" ] && { finish; exit; }
study study_horizon
study study_points_grids
study study_points
study study_perturbation
at_most "centroidal cells: m at which the mean error rises, of 6 steps of 1/2" 1 \
  "$(rises study_horizon 'centroidal cells' 0.5)" "" "004: smoother" 1
trends() { # trends STUDY METHOD
  shown "$2: m at which the error rises, of 6 steps of 1/2" 1 "$(rises "$1" "$2" 0.5)" "" "no reference"
  shown "$2: largest error over the least, m = 3 to 5 in steps of 1/2" 1 "$(ratio "$1" "$2" 0.5)" "" "no reference"
}
for method in lattice hexagonal; do trends study_horizon_grids "$method"; done
for method in perturbed centroidal 'centroidal cells' random; do trends study_horizon "$method"; done
shown "hexagonal: m at which the error rises, of 12 steps of 1/4" 1 "$(rises study_horizon_grids hexagonal 0.25)" "" \
  "no reference"
[ "$again" ] || "$here/draw.sh" "$out"
finish
