#!/usr/bin/env bash
# K of edge cracks and of slanted cracks by element-free Galerkin: nodes, crack lengths, radii, penalties, angles.
# usage: cases/verification/element_free/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

# fact NAME QUANTITY: a number of solution.csv
fact() { kept "$1: $2" awk -F, -v q="$2" '$1 == q { printf "%.12g\n", $3 }' "$runs/$1/solution.csv"; }
# intensity NAME ROW COLUMN: a number of intensity.csv, over s sqrt(pi a) with $half the crack's a
intensity() {
  kept "$1: $2 $3" awk -F, -v row="$2" -v c="$3" -v a="$half" \
    "$names"' ++n == row { printf "%.10g\n", $k[c] / sqrt(4 * atan2(1, 1) * a) }' "$runs/$1/intensity.csv"
}
# edge_crack NAME SETTING...: an edge crack's run
edge_crack() { [ "$again" ] || run_of "$1" scene.yaml "${@:2}"; }
radii=output.intensity.radii
half=0.5

edge_crack few solid.element_free.tip_levels=2 "$radii=[0.1, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.49]"
row "edge crack, nodes of the coarse plate" 1 "$(fact few nodes)" "" "as drawn" 310 350
for k in 3 8; do
  near "edge crack, 320 nodes: K_I/(s sqrt(pi a)), radius $k of 8" 1 "$(intensity few $k K_I)" 2.8246 \
    "Kaya and Erdogan, a/W = 0.5" 0.01
  near "edge crack, 320 nodes: by J, radius $k of 8" 1 "$(intensity few $k K_J)" 2.8246 \
    "Kaya and Erdogan, a/W = 0.5" 0.01
done
at_most "edge crack, 320 nodes: largest violation of a constraint" 1 "$(fact few violation)" 0 "" 1e-8
at_most "edge crack, 320 nodes: forces out of balance" 1 "$(fact few equilibrium)" 0 "" 1e-6
if [ ! "$quick" ]; then
  edge_crack many solid.spacing=0.0555555555555556 solid.element_free.tip_levels=4 \
    "$radii=[0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.49]"
  row "edge crack, nodes of the fine plate" 1 "$(fact many nodes)" "" "as drawn" 1200 1350
  least=$(intensity many 1 K_I) most=$least
  for k in 1 2 3 4 5 6 7 8 9; do
    value=$(intensity many $k K_I)
    least=$(calc "(($value < $least) ? $value : $least)") most=$(calc "(($value > $most) ? $value : $most)")
    near "edge crack, 1234 nodes: K_I/(s sqrt(pi a)), radius $k of 9" 1 "$value" 2.8246 \
      "Kaya and Erdogan, a/W = 0.5" 0.003
  done
  near "edge crack, 1234 nodes: by J at the last radius" 1 "$(intensity many 9 K_J)" 2.8246 \
    "Kaya and Erdogan, a/W = 0.5" 0.003
  at_most "edge crack, 1234 nodes: largest less smallest K_I over radii of 0.2 to 0.98 a" 1 \
    "$(calc "$most / $least - 1")" 0 "" 0.003
  for a in 0.2 0.3 0.4 0.6; do
    half=$a
    case $a in 0.2) f=1.3673 ;; 0.3) f=1.6599 ;; 0.4) f=2.1114 ;; *) f=4.0332 ;; esac
    edge_crack "a_$a" solid.spacing=0.1 "solid.cracks[0].points=[[0, 1.5], [$a, 1.5]]" \
      "$radii=[$(calc "0.9 * (($a < 1 - $a) ? $a : 1 - $a)")]"
    near "edge crack, a/W = $a, 486 nodes: K_I/(s sqrt(pi a))" 1 "$(intensity "a_$a" 1 K_I)" $f "Kaya and Erdogan" 0.01
  done
  half=0.5
  for alpha in 0.1 1 10 100 1000 10000; do
    edge_crack "alpha_$alpha" solid.element_free.penalty=$alpha
    shown "edge crack, 372 nodes, alpha = $alpha E: iterations by conjugate gradients" 1 \
      "$(fact "alpha_$alpha" iterations)" "" ""
  done
  for alpha in 0.1 10 1000 10000; do
    near "edge crack, alpha = $alpha E: K_I/(s sqrt(pi a))" 1 "$(intensity "alpha_$alpha" 1 K_I)" \
      "$(intensity alpha_100 1 K_I)" "alpha = 100 E" 1e-6
  done
  for alpha in 1000 10000; do
    edge_crack "plain_$alpha" solid.element_free.penalty=$alpha solid.element_free.update=hestenes_powell
    shown "edge crack, 372 nodes, alpha = $alpha E: iterations by Hestenes and Powell" 1 \
      "$(fact "plain_$alpha" iterations)" "" ""
  done
  half=0.03
  for angle in 15 30 45 60; do
    ends=$(awk -v b="$angle" 'BEGIN { b *= atan2(0, -1) / 180; c = 0.03 * cos(b); s = 0.03 * sin(b)
      printf "[[%.12g, %.12g], [%.12g, %.12g]]\n", 0.5 - c, 0.5 - s, 0.5 + c, 0.5 + s }')
    [ "$again" ] || run_of "angle_$angle" mixed.yaml "solid.cracks[0].points=$ends"
    for k in 3 6; do
      near "slanted crack, $angle degrees, tip $((k / 3)): K_I/(s sqrt(pi a))" 1 "$(intensity "angle_$angle" $k K_I)" \
        "$(calc "cos($angle * pi / 180)^2")" "cos^2" 0.01
      near "slanted crack, $angle degrees, tip $((k / 3)): K_II/(s sqrt(pi a))" 1 \
        "$(intensity "angle_$angle" $k K_II)" \
        "$(calc "sin($angle * pi / 180) * cos($angle * pi / 180)")" "sin cos" 0.01
    done
  done
  study study
  for method in "nodes graded about the tip" "even nodes" "even nodes and sqrt(r)" "even nodes and the tip basis" \
    "even nodes and the tip basis by diffraction"; do
    shown "edge crack, 20 nodes across, $method: K_I/(s sqrt(pi a))" 1 "$(cell study value "$method" 20 K)" 2.8246 \
      "Kaya and Erdogan, a/W = 0.5"
  done
fi
finish
