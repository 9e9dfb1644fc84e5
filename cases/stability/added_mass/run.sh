#!/usr/bin/env bash
# The least density at which a wall in front of a column of fluid oscillates without growth, over its thickness, the
# column's length and the step: with the load by reaction and with the probe's.
# In a one-dimensional column all fluid is added mass. Where the load comes a step late, the limit is
# rho_s h/(rho_f L) = 1 (Causin, Gerbeau and Nobile 2005).
# The wall's modulus is proportional to its density, so its waves (0.6 cells in 20 us) are always resolved. Only added
# mass can then make a run unstable.
# usage: cases/stability/added_mass/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../../verification/common.sh" "$@"
# shellcheck source=cases/stability/edge.sh
. "$here/../edge.sh"
# A run is bounded if the kinetic energy in its last quarter is at most four times the strain energy in its first
# quarter.
judge() {
  local early
  early=$(of_run "$1" e_strain 'print max(1, n / 4)')
  [ "$(of_run "$1" e_kinetic_solid "a = max(n - n / 4, n); print a <= 4 * ($early + 0)")" = 1 ]
}

point() { # point LOAD THICKNESS LENGTH STEP: lengths in cells, the step in us
  local load=$1 thick=$2 column=$3 step=$4 found long
  long=$(calc "($thick + $column) / 1000")
  found=$(edge 200000 10 0.15 scene coupling.load="$load" domain.size="[$long, 0.008, 0.008]" \
    domain.cells="[$((thick + column)), 8, 8]" solid.bodies.0.high="[$(calc "$thick / 1000"), 0.008, 0.008]" \
    solid.materials.0.density=@ solid.materials.0.youngs_modulus=@e3 stages.0.time_step="${step}e-6")
  found=$(calc "$found / 1000")
  echo "$load,$thick,$column,$step,$found,$(calc "$found * $thick / $column")"
}
{
  for thick in 1 2 4 8; do printf '%s\n' "reaction $thick 40 20" "probe $thick 40 20"; done
  for load in reaction probe; do printf "$load %s\n" "4 40 5" "4 40 40" "4 20 20" "4 80 20"; done
  printf '%s\n' "reaction 8 4 20" "reaction 32 4 20"
} >"$runs/points"
table edges 'load,thickness,column,step_us,density_ratio,mass_ratio' <"$runs/points"
worst() { # worst LOAD: the largest of its edges
  awk -F, -v s="$1" '$1 == s && ($5 > most || $5 == "nan") { most = $5 } END { print most }' "$out/edges.csv"
}
row "reaction: least rho_s/rho_f that holds, the largest of all walls" 1 "$(worst reaction)" "" \
  "0.01: the least tried" 0 0.02
shown "probe: least rho_s/rho_f that holds, the largest of all walls" 1 "$(worst probe)" 0.01 "0.01: the least tried"
# slow RATIO STEPS: a wall of 8 cells before a column of 4, where the fluid within the wall is twice the added mass. The
# largest strain energy in the last quarter of the steps over that in the second.
slow() {
  made "$runs/at/slow-$1" scene domain.size="[0.012, 0.008, 0.008]" domain.cells="[12, 8, 8]" \
    solid.materials.0.density="$1e3" solid.materials.0.youngs_modulus="$1e6" \
    stages.0.steps="$2" || { echo 1e9; return; }
  of_run "$runs/at/slow-$1" e_strain 'printf "%.6g\n", max(n - int(n / 4), n) / max(int(n / 4), int(n / 2))'
}
for wall in '10 2000' '1 2000' '0.3 2000' '0.1 8000'; do
  ratio=${wall% *} steps=${wall#* }
  row "reaction, wall of 8 cells, column of 4, rho_s/rho_f = $ratio: strain energy of steps $((3 * steps / 4)) to \
$steps over $((steps / 4)) to $((steps / 2))" 1 "$(kept "slow $ratio" slow "$ratio" "$steps")" "" "does not grow" 0 1
done
plot edges
finish
