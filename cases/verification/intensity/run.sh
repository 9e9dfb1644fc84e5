#!/usr/bin/env bash
# K of an edge crack and of a slanted crack with bonds, by the nonlocal J and by its mixed form, beside element-free
# Galerkin.
# usage: cases/verification/intensity/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

# intensity NAME ROW COLUMN: a number of intensity.csv over sqrt(pi a), a = 0.5
intensity() {
  kept "$1: $2 $3" awk -F, -v row="$2" -v c="$3" \
    "$names"' ++n == row { printf "%.10g\n", $k[c] / sqrt(2 * atan2(1, 1)) }' \
    "$runs/$1/intensity.csv"
}
# spread NAME FIRST LAST COLUMN: largest over smallest value of these rows, less 1
spread() {
  local k value least most
  least=$(intensity "$1" "$2" "$4") most=$least
  for ((k = $2 + 1; k <= $3; k++)); do
    value=$(intensity "$1" "$k" "$4")
    least=$(calc "(($value < $least) ? $value : $least)") most=$(calc "(($value > $most) ? $value : $most)")
  done
  calc "$most / $least - 1"
}
source="Kaya and Erdogan, a/W = 0.5"

if [ "$quick" ]; then
  run_of few scene.yaml stages.pull.tolerance=1.0e-5
  near "edge crack, 25 spacings: K by J over s sqrt(pi a)" 1 "$(intensity few 5 K_J)" 2.8246 "$source" 0.05
  near "edge crack, 25 spacings: K by the interaction integral" 1 "$(intensity few 5 K_I)" 2.8246 "$source" 0.05
  at_most "edge crack, 25 spacings: largest less smallest K by J over radii of 0.2 to 0.48" 1 \
    "$(spread few 2 5 K_J)" 0 \
    "" 0.002
else
  study study
  for level in 25 50 100; do
    near "edge crack, $level spacings: K by J over s sqrt(pi a)" 1 \
      "$(cell study value bonds $level "K by J")" 2.8246 "$source" "$([ $level = 100 ] && echo 0.01 || echo 0.05)"
    near "edge crack, $level spacings: K by the interaction integral" 1 \
      "$(cell study value bonds $level "K by the interaction integral")" 2.8246 "$source" \
      "$([ $level = 100 ] && echo 0.02 || echo 0.05)"
    at_most "edge crack, $level spacings: largest less smallest K by J over radii of 0.2 to 0.48" 1 \
      "$(spread "runs/study/bonds/$level/1" 2 5 K_J)" 0 "" 0.002
    at_most "edge crack, $level spacings: K_II by the interaction integral" 1 \
      "$(intensity "runs/study/bonds/$level/1" 5 K_II)" 0 "symmetry" 1e-10
  done
  ends='solid.cracks[0].points=[[0.3586, 0.3586], [0.6414, 0.6414]]'
  run_of slanted ../element_free/mixed.yaml "$ends" solid.materials[0].poisson_ratio=0.3333 \
    'output.intensity.radii=[0.1, 0.2, 0.3]'
  for h in 0.02 0.01 0.005; do
    radii='[0.12, 0.2, 0.3]'
    run_of "slanted_$h" mixed.yaml "solid.spacing=$h" "output.intensity.radii=$radii"
    for c in K_I K_II; do
      near "slanted crack of $(calc "0.4 / $h") spacings, 45 degrees: $c over that of element-free Galerkin" 1 \
        "$(calc "$(intensity "slanted_$h" 6 $c) / $(intensity slanted 6 $c)")" 1 "the same plate" \
        "$([ $h = 0.005 ] && echo 0.05 || echo 0.15)"
    done
  done
  if command -v gnuplot >/dev/null && [ ! "$again" ]; then "$here/draw.sh" "$out"; fi
fi
finish
