#!/usr/bin/env bash
# Whether an elastic wall in a channel (Re = 20, two particles thick) stays stable, over its density and stiffness, with
# explicit and with strong coupling.
# usage: cases/stability/stiffness/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../../verification/common.sh" "$@"
# shellcheck source=cases/stability/edge.sh
. "$here/../edge.sh"
# A run of 200 steps is bounded if the wall, late in the run, is less than twice as fast as in the first half, and never
# twice as fast as the stream.
judge() {
  local density
  density=$(sed -n '/^solid/,$s/.*density: *\([0-9.e+-]*\).*/\1/p' "$1/scene.resolved.yaml" | head -n 1)
  [ "$(of_run "$1" e_kinetic_solid \
    "print max(n - 10, n) <= 4 * max(n - 39, n - 20) && max(1, n) <= 2 * $density * 96")" = 1 ]
}
point() { # point SCHEME E/(rho_f U2) RATIO: the step has at most about 500 substeps of a wall as dense as the fluid
  local step held=1
  step=$(calc "($2 > 1.0e7 ? 3.7e-3 * sqrt(1.0e10 / $2) : 0.1)")
  holds "$runs/at/$1-$2-$3" scene coupling.scheme="$1" solid.materials.0.youngs_modulus="$2" \
    solid.materials.0.density="$3" \
    stages.bend.time_step="$step" || held=0
  echo "$1,$2,$3,$step,$held"
}
for e in 1e3 1e4 1e6 1e8 1e10; do
  for scheme in explicit strong; do printf "$scheme $e %s\n" 100 10 3 1 0.3; done
done >"$runs/points"
table grid 'scheme,stiffness,density_ratio,step,holds' <"$runs/points"
plot grid <<'END'
set logscale xy; set xlabel 'E/(rho_f U^2)'; set ylabel 'rho_s/rho_f'; set xrange [300:1e11]; set yrange [0.1:1000];
set format x '1e%T'; set key top right horizontal
f = 'grid.csv'; of(s, h) = strcol(1) eq s && $5 == h ? $3 : NaN
plot f using ($2 * 0.7):(of('explicit', 1)) with points pt 7 ps 2 lc 'web-green' title 'explicit: holds', \
  '' using ($2 * 0.7):(of('explicit', 0)) with points pt 2 ps 2 lc 'red' title 'diverges', \
  '' using ($2 * 1.4):(of('strong', 1)) with points pt 5 ps 2 lc 'web-blue' title 'strong: holds', \
  '' using ($2 * 1.4):(of('strong', 0)) with points pt 3 ps 2 lc 'red' title 'diverges'
END
finish
