#!/usr/bin/env bash
# How light an elastic wall can be that a channel's flow bends (Re = 20, two particles thick), over its stiffness; explicit and strong.
# usage: cases/stability/stiffness/run.sh [FRANA [RUNS [OUT [quick]]]]
. "$(dirname "$0")/../../verification/common.sh" "$@"
. "$here/../edge.sh"
# Bounded: the wall is late in its 200 steps not twice as fast as it ever was in their first half, and never twice as fast as the stream.
judge() {
  local density
  density=$(sed -n '/^solid/,$s/.*density: *\([0-9.e+-]*\).*/\1/p' "$1/scene.resolved.yaml" | head -n 1)
  [ "$(of_run "$1" e_kinetic_solid "print max(n - 10, n) <= 4 * max(n - 39, n - 20) && max(1, n) <= 2 * $density * 96")" = 1 ]
}
point() { # point SCHEME E/(rho_f U2): a step of at most some 500 substeps of a wall as heavy as the fluid
  local step
  step=$(calc "($2 > 1.0e7 ? 3.7e-3 * sqrt(1.0e10 / $2) : 0.1)")
  echo "$1,$2,$step,$(edge 100 0.3 0.4 scene coupling.scheme="$1" solid.materials.0.youngs_modulus="$2" \
    solid.materials.0.density=@ stages.bend.time_step="$step")"
}
for e in 1e3 1e4 1e5 1e6 1e8 1e10; do printf '%s\n' "explicit $e" "strong $e"; done >"$runs/points"
table edges 'scheme,stiffness,step,density_ratio' <"$runs/points"
plot edges <<'END'
set logscale xy; set xlabel 'E/(rho_f U^2)'; set ylabel 'least rho_s/rho_f that holds 200 steps'; set yrange [0.1:100]; set key top right; set format x '1e%T'
f = 'edges.csv'; of(k) = strcol(1) eq k ? $4 : NaN
plot f using 2:(of('explicit')) with points pt 7 title 'explicit', '' using 2:(of('strong')) with points pt 6 title 'strong', 0.3 with lines lc 'grey' title 'the least tried'
END
finish
