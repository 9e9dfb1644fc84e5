#!/usr/bin/env bash
# How light a wall can be that pushes a column of fluid, over its thickness, the column's length and the step; explicit and strong.
# A one-dimensional column is all added mass: the explicit scheme's edge is rho_s h/(rho_f L) = 1 (Causin, Gerbeau and Nobile 2005).
# usage: cases/stability/added_mass/run.sh [FRANA [RUNS [OUT [quick]]]]
. "$(dirname "$0")/../../verification/common.sh" "$@"
. "$here/../edge.sh"
# Bounded: the wall, which the fluid holds back, is never twice as fast as in a free fall.
judge() {
  local mass
  mass=$(sed -n '/^solid/,$s/.*density: *\([0-9.e+-]*\).*/\1/p' "$1/scene.resolved.yaml" | head -n 1)
  mass=$(calc "$mass * $(sed -n 's/.*"particles": *\([0-9]*\).*/\1/p' "$1/run.json")")
  [ "$(of_run "$1" e_kinetic_solid "for (k = 1; k <= n; k++) if (!(x[k] <= 2 * $mass * (1e-3 * t[k]) ^ 2)) bad++; print bad + 0")" = 0 ]
}
point() { # point SCHEME THICKNESS LENGTH STEP, in cells, seconds
  local scheme=$1 thick=$2 length=$3 step=$4 found
  found=$(edge 1000 0.02 0.06 scene coupling.scheme="$scheme" domain.size="[$length, 4, 4]" domain.cells="[$length, 4, 4]" \
    solid.bodies.0.low="[$((length / 2)), 0, 0]" solid.bodies.0.high="[$((length / 2 + thick)), 4, 4]" \
    solid.materials.0.density=@ stages.0.time_step="$step")
  echo "$scheme,$thick,$((length - thick)),$step,$found,$(calc "$found * $thick / ($length - $thick)")"
}
{
  for thick in 1 2 3 4 6 8; do printf '%s\n' "explicit $thick 48 0.05" "strong $thick 48 0.05"; done
  printf '%s\n' "explicit 1 48 0.2" "explicit 4 48 0.2" "explicit 1 48 0.0125" "explicit 4 48 0.0125" \
    "explicit 4 12 0.05" "explicit 4 24 0.05" "explicit 4 96 0.05" "strong 4 96 0.05"
} >"$runs/points"
table edges 'scheme,thickness,column,step,density_ratio,mass_ratio' <"$runs/points"
finish
