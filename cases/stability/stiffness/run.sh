#!/usr/bin/env bash
# How light an elastic wall can be that a channel's flow bends (Re = 20, two particles thick), over its stiffness; explicit and strong.
# usage: cases/stability/stiffness/run.sh [FRANA [RUNS [OUT [quick]]]]
. "$(dirname "$0")/../../verification/common.sh" "$@"
. "$here/../edge.sh"
# Bounded: the wall is late in the run not twice as fast as it ever was in the first half of its 200 steps.
judge() { [ "$(of_run "$1" e_kinetic_solid 'print max(n - 10, n) <= 4 * max(n - 39, n - 20)')" = 1 ]; }
point() { # point SCHEME E/(rho_f U2): a step of at most some 500 substeps of a wall as heavy as the fluid
  local step
  step=$(calc "$2 > 1.0e7 ? 3.7e-3 * sqrt(1.0e10 / $2) : 0.1")
  echo "$1,$2,$step,$(edge 100 0.3 0.3 scene coupling.scheme="$1" solid.materials.0.youngs_modulus="$2" \
    solid.materials.0.density=@ stages.bend.time_step="$step")"
}
for e in 1e3 1e4 1e5 1e6 1e7 1e8 1e9 1e10; do printf '%s\n' "explicit $e" "strong $e"; done >"$runs/points"
table edges 'scheme,stiffness,step,density_ratio' <"$runs/points"
finish
