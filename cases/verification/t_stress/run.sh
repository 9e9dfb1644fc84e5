#!/usr/bin/env bash
# T-stress of a central crack and of an edge crack, by element-free Galerkin and with bonds.
# usage: cases/verification/t_stress/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

# t_of NAME ROW: T of a row of intensity.csv, under a traction of 1 Pa
t_of() {
  kept "$1: $2" awk -F, -v row="$2" "$names"' ++n == row { printf "%.8g\n", $k["T"] }' "$runs/$1/intensity.csv"
}
edge=-0.4220
source="boundary collocation, 80 to 280 terms: -0.4219 to -0.4252"
radii='output.intensity.radii=[0.2, 0.3, 0.4, 0.49]'
for across in 8 14 20 26; do
  [ ! "$quick" ] || [ $across = 8 ] || continue
  run_of "edge_$across" ../element_free/scene.yaml "solid.spacing=$(calc "1 / $across")" "$radii"
  nodes=$(kept "edge_$across: nodes" awk -F, '$1 == "nodes" { print $3 }' "$runs/edge_$across/solution.csv")
  for k in 1 2 3 4; do
    near "edge crack, a/W = 0.5, $nodes nodes: T/s, radius $k of 4" 1 "$(t_of "edge_$across" $k)" $edge "$source" \
      "$([ $across = 8 ] && echo 0.025 || echo 0.01)"
  done
done
if [ ! "$quick" ]; then
  run_of centre ../element_free/mixed.yaml 'solid.cracks[0].points=[[0.47, 0.5], [0.53, 0.5]]' \
    solid.element_free.tip_patch=3
  for k in 1 2 3 4 5 6; do
    near "central crack, a/W = 0.03: T/s, tip $(((k - 1) / 3)), radius $(((k - 1) % 3 + 1)) of 3" 1 \
      "$(t_of centre $k)" -1 "a crack in an unbounded plate" 0.01
  done
  for h in 0.02 0.01; do
    run_of "bonds_$h" ../intensity/scene.yaml "solid.spacing=$h"
    n=$(calc "0.5 / $h")
    for k in 3 4 5; do
      near "edge crack with bonds, $n spacings a crack: T/s, radius $k of 5" 1 "$(t_of "bonds_$h" $k)" $edge "$source" \
        "$([ $k = 3 ] && echo 0.12 || echo 0.03)"
    done
    for k in 1 2; do
      shown "edge crack with bonds, $n spacings a crack: T/s, radius $k of 5" 1 "$(t_of "bonds_$h" $k)" $edge "$source"
    done
  done
fi
finish
