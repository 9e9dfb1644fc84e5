#!/usr/bin/env bash
# The flow on the axis and half way to the wall, at six times, compared with the series solution.
# usage: cases/verification/start_up/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study
axis=(.099956 .197746 .370386 .699455 .912477 .992578) half=(.096298 .176878 .304159 .537481 .688112 .744752) k=0
for t in 0.05 0.1 0.2 0.5 1 2; do
  at() { (cd "$runs/runs/study/RK3/32/1" && "$here/velocity.sh" "$1" "$t"); }
  near "32 cells: axis at nu t/h^2 = $t" 1 "$(kept "axis at $t" at 0)" "${axis[k]}" "series solution" 2e-3
  near "32 cells: half way to the wall at nu t/h^2 = $t" 1 "$(kept "half way at $t" at 1)" "${half[k]}" \
    "series solution" 2e-3
  k=$((k + 1))
done
for level in 32 64; do
  row "order to $level cells, largest error" 1 "$(cell study order RK3 $level 'largest error')" 2 "second order" 1.95 \
    2.05
done
finish
