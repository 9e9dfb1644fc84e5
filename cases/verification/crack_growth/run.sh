#!/usr/bin/env bash
# Cracks that grow by the maximum hoop stress: kink angles of slanted cracks, a straight crack, a crack near a hole
# beside the one with bonds.
# usage: cases/verification/crack_growth/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

# grown NAME STEP TIP COLUMN: a number of growth.csv; STEP -1: the last one
grown() {
  kept "$1: $2 $3 $4" awk -F, -v step="$2" -v tip="$3" -v c="$4" \
    "$names"' $k["tip"] == tip && (step < 0 || $k["step"] == step) { v = $k[c] } END { printf "%.10g\n", v }' \
    "$runs/$1/growth.csv"
}
# ends ANGLE: the ends of a crack of half length 0.03 about the middle
ends() {
  awk -v b="$1" 'BEGIN { b *= atan2(0, -1) / 180; c = 0.03 * cos(b); s = 0.03 * sin(b)
    printf "[[%.12g, %.12g], [%.12g, %.12g]]\n", 0.5 - c, 0.5 - s, 0.5 + c, 0.5 + s }'
}
crack='solid.cracks[0].points'
source="Erdogan and Sih with K of an unbounded plate"

run_of straight straight.yaml
at_most "straight crack: largest distance of its tip from the line, over the length grown" 1 \
  "$(calc "$(kept "straight: off" awk -F, "$names"' { d = $k["y"] - 1.5; if (d < 0) d = -d; if (d > most) most = d }
    END { printf "%.10g\n", most }' "$runs/straight/growth.csv") / 0.2")" 0 "symmetry" 1e-3
for angle in 15 30 45 60 75; do
  [ ! "$quick" ] || [ $angle = 45 ] || continue
  t="($angle * pi / 180)" s="sqrt(cos($angle * pi / 180)^2 + 8 * sin($angle * pi / 180)^2)"
  reference=$(calc "-360 / pi * atan2(2 * sin$t, cos$t + $s)")
  half="(0.5 * $reference * pi / 180)"
  run_of "slanted_$angle" slanted.yaml "$crack=$(ends $angle)"
  for tip in 0 1; do
    kink=$(grown "slanted_$angle" 0 $tip kink)
    row "slanted crack, $angle degrees, tip $tip: kink" degrees "$kink" "$reference" "$source" \
      "$(calc "$reference - 1.5")" "$(calc "$reference + 1.5")"
    near "slanted crack, $angle degrees, tip $tip: K_eq/(s sqrt(pi a))" 1 \
      "$(calc "$(grown "slanted_$angle" 0 $tip K_eq) / sqrt(pi * 0.03)")" \
      "$(calc "cos$t * cos$half * (cos$t * cos$half^2 - 1.5 * sin$t * sin(2 * $half))")" "$source" 0.03
  done
done
if [ ! "$quick" ]; then
  run_of slanted_on slanted.yaml "$crack=$(ends 45)" solid.element_free.growth.steps=5
  for tip in 0 1; do
    direction=$(grown slanted_on -1 $tip direction)
    at_most "slanted crack, 45 degrees, tip $tip: the fifth part against the line across the load" degrees \
      "$(calc "$direction - 180 * int($direction / 90)")" 0 "largest energy release" 5
  done
  run_of hole hole.yaml
  run_of bonds bonds.yaml
  run_of pulled ../../plate_hole/a.yaml solid.spacing=5.0e-4 'solid.constraints[0].high=[0.03, 5.0e-4]'
  same "crack near a hole by the maximum hoop stress: why it ends" "" \
    "$(kept "hole: end" text "$runs/hole/run.json" growth_end)" \
    "a tip is next to the border or to a hole" "expected: it is drawn in"
  # from the hole, and from the element-free path at the same x, of each tip of the bonds' crack.csv; mm
  off() {
    awk -F, -v margin="$2" "$names"' FNR == NR { x[++n] = $k["x"]; y[n] = $k["y"]; next }
      { X = $k["tip_x"]; Y = $k["tip_y"]; if (X < x[1] || sqrt((X - 0.02)^2 + (Y - 0.008)^2) < 0.004 + margin) next
        least = 1
        for (i = 1; i < n; i++) {
          dx = x[i + 1] - x[i]; dy = y[i + 1] - y[i]; f = ((X - x[i]) * dx + (Y - y[i]) * dy) / (dx * dx + dy * dy)
          f = f < 0 ? 0 : f > 1 ? 1 : f; d = sqrt((x[i] + f * dx - X)^2 + (y[i] + f * dy - Y)^2)
          if (d < least) least = d }
        if (least > most) most = least }
      END { printf "%.4g\n", 1e3 * most }' "$runs/hole/growth.csv" "$runs/$1/crack.csv"
  }
  at_most "crack near a hole: farthest tip with bonds from the element-free path, a horizon from the hole" mm \
    "$(kept "bonds: off" off bonds 0.0015)" 0 "a horizon is 1.5 mm" 1.5
  shown "the same up to the hole" mm "$(kept "bonds: off whole" off bonds -1)" "" ""
  shown "the same, pulled at once by 22 MPa" mm "$(kept "pulled: off" off pulled -1)" "" ""
  starts=$(kept "bonds: starts" awk -F, "$names"' FNR == 1 { next } !x0 { x0 = $k["tip_x"]; next }
    $k["tip_x"] > x0 + 7.5e-4 { printf "%.6g\n", $k["t"]; exit }' "$runs/bonds/crack.csv")
  near "crack near a hole with bonds: opening at which it runs, over that of the maximum hoop stress" 1 \
    "$(calc "$starts / (1e-5 * $(grown hole 0 0 load))")" 1 "K_I = toughness at the crack's tip" 0.2
  if command -v gnuplot >/dev/null && [ ! "$again" ]; then "$here/draw.sh" "$runs" "$out"; fi
fi
finish
