#!/usr/bin/env bash
# The slip at the walls of a slit, over the step: with the forcing of the load by reaction, which has feedback and no
# iterations, and with that of the other loads, over its number of iterations. The slip's share of the flow is the bulk
# velocity under a given gradient over that without slip (100 iterations at the shortest step), minus one.
# usage: cases/stability/forcing/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../../verification/common.sh" "$@"
# shellcheck source=cases/stability/edge.sh
. "$here/../edge.sh"
point() { # point DIFFUSION STEP ITERATIONS: the step is in units of the explicit viscous limit; 0: with feedback
  local dir=$runs/at/$1-$2-$3 steps set="coupling.load=probe coupling.forcing_iterations=$3"
  [ "$3" != 0 ] || set=coupling.load=reaction
  steps=$(calc "int(200 / (0.1375 * $2) + 0.5)")
  if ! [ -f "$dir.u" ] || [ "$(head -n 1 "$dir.u")" != "$build" ]; then
    # shellcheck disable=SC2086 # settings are words
    if made "$dir" scene fluid.diffusion="$1" $set \
      stages.0.time_step="$(calc "0.1375 * $2")" stages.0.steps="$steps" \
      output.series_every="$steps"; then
      printf '%s\n' "$build" "$(of_run "$dir" u_bulk 'print x[n]')" >"$dir.u"
    else
      printf '%s\n' "$build" nan >"$dir.u"
    fi
  fi
  echo "$1,$2,$3,$(tail -n 1 "$dir.u")"
}
{
  printf '%s 0\n' 'explicit 1' 'explicit 0.3' 'explicit 0.1' 'implicit 10'
  printf 'explicit 1 %s\n' 1 2 3 5 10 20 50 100
  printf 'explicit 0.1 %s\n' 1 2 5 10 100
} >"$runs/points"
table slip 'diffusion,step,iterations,bulk_velocity' <"$runs/points"
exact=$(awk -F, '$1 == "explicit" && $2 == 0.1 && $3 == 100 { print $4 }' "$out/slip.csv")
of_flow() { # of_flow STEP: the slip's share with feedback
  awk -F, -v e="$exact" -v d="$1" '$2 == d && $3 == 0 { printf "%.6g\n", $4 / e - 1 }' "$out/slip.csv"
}
for step in 1 0.1 10; do
  at_most "reaction: slip's share of the flow, at $step times the viscous limit" 1 "$(of_flow $step)" "" \
    "the wall stands still" 0.02
done
row "reaction: slip at the viscous limit over that at a tenth of it" 1 "$(calc "$(of_flow 1) / $(of_flow 0.1)")" 1 \
  "does not depend on the step" 0.9 1.1
plot slip
finish
