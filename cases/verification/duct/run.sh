#!/usr/bin/env bash
# Flow, resistance and three velocities of a square duct, compared with the series solution.
# usage: cases/verification/duct/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study
study study_32
mean=$(cell study_32 value RK3 32 'mean velocity') fine=$(cell study value RK3 48 'mean velocity')
near "32 x 32 cells: flow for G/mu = 1" m3/s "$mean" 0.0351442537 "series solution" 2e-3
near "32 x 32 cells: velocity in the centre" m/s "$(cell study_32 value RK3 32 centre)" 0.0736713534 \
  "series solution" 2e-3
near "32 x 32 cells: velocity half way to a wall" m/s "$(cell study_32 value RK3 32 'half way to a wall')" \
  0.0573349065 "series solution" 2e-3
near "32 x 32 cells: velocity half way to an edge" m/s "$(cell study_32 value RK3 32 'half way to an edge')" \
  0.0452861581 "series solution" 2e-3
shown "48 x 48 cells: flow for G/mu = 1" m3/s "$fine" 0.0351442537 "series solution"
shown "48 x 48 cells: f Re" 1 "$(calc "2 / $fine")" 56.90831 "series solution"
for level in 24 48; do
  row "order to $level x $level cells: flow" 1 "$(cell study order RK3 $level 'mean velocity')" 2 "second order" 1.95 \
    2.05
done
finish
