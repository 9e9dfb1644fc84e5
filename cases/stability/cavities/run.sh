#!/usr/bin/env bash
# How narrow a slit may be: its flow over h2/12 G/mu, and the longest step over the one without anything immersed, from one cell on.
# usage: cases/stability/cavities/run.sh [FRANA [RUNS [OUT [quick]]]]
. "$(dirname "$0")/../../verification/common.sh" "$@"
. "$here/../edge.sh"
# Bounded: never faster than the slit twice as wide, and at rest in the mean at the end.
judge() { [ "$(of_run "$1" u_bulk 'print max(1, n) < 1 && max(n, n) - x[n - 1] < 0.1 * max(n, n)')" = 1 ]; }
point() { # point DIFFUSION WIDTH, in cells
  local kind=$1 width=$2 dir=$runs/flow/$1-$2 walls cells step ratio
  cells=$((width + 8))
  walls=("fluid.diffusion=$kind" "domain.size=[4, $cells, 4]" "domain.cells=[4, $cells, 4]"
    "solid.bodies.0.high=[4, 4, 4]" "solid.bodies.1.low=[0, $((4 + width)), 0]" "solid.bodies.1.high=[4, $cells, 4]")
  step=$([ "$kind" = explicit ] && echo 0.1375 || echo 1.375)
  made "$dir" scene "${walls[@]}" "stages.0.time_step=$step" stages.0.steps="$(calc "int(2 * ($width + 2) ^ 2 / $step) + 20")" output.series_every=20
  # of the whole height; between the walls alone there is as good as all of it
  ratio=$(calc "$(of_run "$dir" u_bulk 'print x[n]') * $cells / $width / (1e-3 * $width ^ 2 / 12)")
  echo "$kind,$width,$ratio,$(edge 0.07 2 0.02 scene "${walls[@]}" stages.0.time_step=@ stages.0.steps=600 output.series_every=20)"
}
for width in 1 2 3 4 6 8 12 16; do printf '%s\n' "explicit $width" "implicit $width"; done >"$runs/points"
table slit 'diffusion,width,flow_over_exact,longest_step' <"$runs/points"
finish
