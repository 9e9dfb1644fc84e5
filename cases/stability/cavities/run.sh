#!/usr/bin/env bash
# The flow through a narrow slit over h^2/12 G/mu, with the forcings of the load by reaction and of the other loads, and
# the longest step over the one without an immersed body, for widths from one cell on.
# usage: cases/stability/cavities/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../../verification/common.sh" "$@"
# shellcheck source=cases/stability/edge.sh
. "$here/../edge.sh"
# A run is bounded if the bulk velocity stays below 1, and grows by less than 10 % between the last two samples.
judge() { [ "$(of_run "$1" u_bulk 'print max(1, n) < 1 && max(n, n) - max(n - 1, n - 1) < 0.1 * max(n, n)')" = 1 ]; }
point() { # point FORCING WIDTH: reaction or probe, with explicit diffusion, or implicit; the width in cells
  local kind=$1 width=$2 dir=$runs/flow/$1-$2 walls cells step ratio diffusion=explicit load=$1
  [ "$kind" != implicit ] || diffusion=implicit load=probe
  cells=$((width + 8))
  walls=("fluid.diffusion=$diffusion" "coupling.load=$load"
    "domain.size=[4, $cells, 4]" "domain.cells=[4, $cells, 4]"
    "solid.bodies.0.high=[4, 4, 4]" "solid.bodies.1.low=[0, $((4 + width)), 0]" "solid.bodies.1.high=[4, $cells, 4]")
  step=$([ "$diffusion" = explicit ] && echo 0.1375 || echo 1.375)
  made "$dir" scene "${walls[@]}" "stages.0.time_step=$step" \
    stages.0.steps="$(calc "int(2 * ($width + 2) ^ 2 / $step) + 20")" output.series_every=20 \
    output.fluid_probes.at="[$(seq -s, -f '[2, %.1f, 2]' 4.5 $((3 + width)).5 | sed 's/\],\[/], [/g')]" \
      output.fluid_probes.every=20
  # without the flow inside the walls
  ratio=$(awk -F, 'NR > 2 { if ($1 != step) { step = $1; sum = 0 } sum += $7 } END { print sum }' \
    "$dir/fluid_probes.csv")
  ratio=$(calc "$ratio / (1e-3 * $width ^ 3 / 12)")
  echo "$kind,$width,$ratio,$(
    edge 0.07 2 0.02 scene "${walls[@]}" stages.0.time_step=@ stages.0.steps=600 output.series_every=20)"
}
for width in 1 2 3 4 8 16; do printf "%s $width\n" reaction probe implicit; done >"$runs/points"
table slit 'forcing,width,flow_over_exact,longest_step' <"$runs/points"
for kind in reaction probe implicit; do
  near "$kind: flow through 16 cells over the exact one" 1 "$(in_table slit $kind 16 3)" 1 "Poiseuille's flow" 0.03
  near "$kind: flow through 8 cells over the exact one" 1 "$(in_table slit $kind 8 3)" 1 "Poiseuille's flow" 0.1
done
for width in 1 2 4 8; do
  near "reaction: longest step at $width cells over that at 16" 1 \
    "$(calc "$(in_table slit reaction $width 4) / $(in_table slit reaction 16 4)")" 1 "the fluid's own" 0.02
done
plot slit
finish
