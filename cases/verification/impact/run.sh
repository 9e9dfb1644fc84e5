#!/usr/bin/env bash
# Impact and contact against theory: two bars, two spheres (Hertz), the energy of bodies that part whole, and a disc
# pressed at two ends of its diameter.
# usage: cases/verification/impact/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

# run NAME SCENE: runs a scene once
run() {
  ! is_done "$runs/$1" || [ ! "$runs/$1/run.json" -ot "$frana" ] || rm -rf "${runs:?}/$1"
  is_done "$runs/$1" || {
    rm -rf "${runs:?}/$1"
    "$frana" run "$2" --out "$runs/$1" >"$runs/$1.log" 2>&1 || { cat "$runs/$1.log" >&2; return 1; }
  }
}
# of_scene NAME WHAT: a number of the impact in NAME.yaml
of_scene() {
  run "$1" "$here/$1.yaml" &&
    awk -F, -v what="$2" -f "$here/measure.awk" "$runs/$1/bodies.csv" "$runs/$1/series.csv"
}
# of_spheres R X Y Z WHAT: a number of the impact of spheres of R spacings along X Y Z
of_spheres() {
  local name=spheres_$1_$2$3$4
  awk -v r="$1" -v x="$2" -v y="$3" -v z="$4" -v v=0.02 -f "$here/spheres.awk" >"$runs/$name.yaml"
  run "$name" "$runs/$name.yaml" &&
    awk -F, -v what="$5" -f "$here/measure.awk" "$runs/$name/bodies.csv" "$runs/$name/series.csv"
}
# of_disc NAME COMMAND WHAT
of_disc() { run "$1" "$here/$1.yaml" && (cd "$runs/$1" && "$here/$2.sh" "$3"); }

# energies NAME COMMAND...: energy and momentum of an impact
energies() {
  local name=$1
  shift
  at_most "$name: energy after the impact over that before, less 1" 1 "$(kept "$name: energy" "$@" energy)" 0 \
    "kinetic + strain + contact" 1e-3
  at_most "$name: the same at any time" 1 "$(kept "$name: worst" "$@" worst)" 0 "kinetic + strain + contact" 5e-3
  shown "$name: largest share of the energy in contact" 1 "$(kept "$name: held" "$@" held)" "" ""
  at_most "$name: change of momentum" 1 "$(kept "$name: momentum" "$@" momentum)" 0 "" 1e-10
}
for bars in bars strips; do
  modulus=6/5 width=64
  [ $bars = bars ] || modulus=9/8 width=8
  near "$bars: duration of contact" "1/c0" "$(kept "$bars: duration" of_scene $bars duration)" \
    "$(calc "200 / sqrt($modulus)")" "2 L/sqrt(C11/rho)" 0.02
  near "$bars: mean force" "E" "$(kept "$bars: mean" of_scene $bars mean)" \
    "$(calc "0.001 * sqrt($modulus) * $width")" "rho c A V/2" 0.02
  row "$bars: velocity of the first after the impact over that before" 1 "$(kept "$bars: left" of_scene $bars left)" 0 \
    "velocities are exchanged" -0.02 0.02
  row "$bars: velocity of the second after the impact over the first's before" 1 \
    "$(kept "$bars: gained" of_scene $bars gained)" 1 "velocities are exchanged" 0.98 1.02
  energies $bars of_scene $bars
done
# Hertz, of spheres with E* = E/(2 (1 - nu^2)), R* = R/2, m* = m/2, m of the round sphere
for r in 10 16 24; do
  [ ! "$quick" ] || [ $r = 10 ] || continue
  delta=$(calc "(15 * 2 / 3 * pi * $r^3 * 0.02^2 / (16 * 8 / 15 * sqrt($r / 2)))^0.4")
  for way in "1 0 0" "13 8 5"; do
    read -r x y z <<<"$way"
    name="spheres of $r along [$x $y $z]"
    judge=(shown)
    [ $r != 24 ] || judge=(near 0.1)
    "${judge[0]}" "$name: duration over Hertz's" 1 \
      "$(calc "$(kept "$name: duration" of_spheres $r "$x" "$y" "$z" duration) / (2.9432 * $delta / 0.02)")" 1 \
      "2.943 delta/V" "${judge[@]:1}"
    "${judge[0]}" "$name: largest force over Hertz's" 1 \
      "$(calc "$(kept "$name: force" of_spheres $r "$x" "$y" "$z" force) / (32 / 45 * sqrt($r / 2) * $delta^1.5)")" 1 \
      "4/3 E* sqrt(R*) delta^1.5" "${judge[@]:1}"
    shown "$name: coefficient of restitution" 1 \
      "$(kept "$name: restitution" of_spheres $r "$x" "$y" "$z" restitution)" "" "along the line of centres"
    shown "$name: force across over force along" 1 "$(kept "$name: across" of_spheres $r "$x" "$y" "$z" across)" 0 \
      "round spheres"
    energies "$name" of_spheres $r "$x" "$y" "$z"
  done
done
# A disc under two forces spread over arcs of the half angle a = 0.1: means over the arc of the chord's solution
near "disc: stress across the loaded diameter at the centre" "2 F/(pi D)" \
  "$(kept "disc: xx" of_disc disc centre xx)" "$(calc "(sin(0.1) - 4 / 3 * sin(0.1)^3) / 0.1")" \
  "forces along chords" 0.03
near "disc: stress along the loaded diameter at the centre" "2 F/(pi D)" \
  "$(kept "disc: yy" of_disc disc centre yy)" "$(calc "(sin(0.1) - 4 * (sin(0.1) - sin(0.1)^3 / 3)) / 0.1")" \
  "forces along chords" 0.03
at_most "disc: the crack's largest distance from the loaded diameter" spacings \
  "$(kept "split: off" of_disc split split off)" 0 "within a horizon of the diameter" 3
shown "disc: length of the crack when the run ends" D "$(kept "split: length" of_disc split split length)" "" ""
shown "disc: 2 F/(pi D) when the first bond breaks" "E s0" "$(kept "split: first" of_disc split split first)" "" ""
finish
