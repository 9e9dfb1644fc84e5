#!/usr/bin/env bash
# The least density at which a wall in front of a column of fluid oscillates without growth, over its thickness, the
# column's length and the step, with explicit and with strong coupling.
# In a one-dimensional column all fluid is added mass. The explicit scheme's limit is rho_s h/(rho_f L) = 1 (Causin,
# Gerbeau and Nobile 2005).
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

point() { # point SCHEME THICKNESS LENGTH STEP: lengths in cells, the step in us
  local scheme=$1 thick=$2 column=$3 step=$4 found long
  long=$(calc "($thick + $column) / 1000")
  found=$(edge 200000 100 0.15 scene coupling.scheme="$scheme" domain.size="[$long, 0.008, 0.008]" \
    domain.cells="[$((thick + column)), 8, 8]" solid.bodies.0.high="[$(calc "$thick / 1000"), 0.008, 0.008]" \
    solid.materials.0.density=@ solid.materials.0.youngs_modulus=@e3 stages.0.time_step="${step}e-6")
  found=$(calc "$found / 1000")
  echo "$scheme,$thick,$column,$step,$found,$(calc "$found * $thick / $column")"
}
{
  for thick in 1 2 4 8; do printf '%s\n' "explicit $thick 40 20" "strong $thick 40 20"; done
  printf '%s\n' "explicit 4 40 5" "explicit 4 40 40" "explicit 4 20 20" "explicit 4 80 20"
} >"$runs/points"
table edges 'scheme,thickness,column,step_us,density_ratio,mass_ratio' <"$runs/points"
plot edges <<'END'
set logscale xy; set xlabel 'thickness, particles'; set xrange [0.8:10]; set ylabel 'least rho_s/rho_f that holds';
set key bottom left
f = 'edges.csv'; of(s, l, d) = strcol(1) eq s && $3 == l && $4 == d ? $5 : NaN
plot f using 2:(of('explicit', 40, 20)) with points pt 7 title 'explicit, column of 40 cells, 20 us', \
  '' using 2:(of('explicit', 40, 5)) with points pt 1 ps 2 title '5 us', \
  '' using 2:(of('explicit', 40, 40)) with points pt 2 ps 2 title '40 us', \
  '' using 2:(of('explicit', 20, 20)) with points pt 8 title '20 cells', \
  '' using 2:(of('explicit', 80, 20)) with points pt 10 title '80 cells', \
  '' using 2:(of('strong', 40, 20)) with points pt 6 title 'strong, 40 cells (0.1: the least tried)', \
  40 / x with lines lc 'black' title 'rho_s h = rho_f L'
END
finish
