#!/usr/bin/env bash
# Glass plates with a branching crack: published times and positions; mirror images to the bit, wherever the plate is in
# the coordinates, refined or not.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# go NAME SCENE [--set ...]: runs and evaluates a scene
go() {
  code 0 ranks 1 run "$2" --out "$1" "${@:3}"
  code 0 ranks 1 post "$1"
}
# cell NAME QUANTITY: a number of post/crack-summary.csv
cell() {
  awk -v q="$2" '{ gsub(/"/, ""); v = $0; sub(/.*,/, "", v); sub(/,[^,]*,[^,]*$/, ""); if ($0 == q) print v }' \
    "$1/post/crack-summary.csv"
}
# within QUANTITY LOW HIGH VALUE
within() {
  awk -v x="$4" -v a="$2" -v b="$3" 'BEGIN { exit !(x != "" && x + 0 >= a && x + 0 <= b) }' ||
    fail "$1 is $4, not $2 to $3"
}
# mirrored RUN AXIS SPACING: only if h5dump is installed
mirrored() {
  ! command -v h5dump >/dev/null || "$source/cases/crack.sh" symmetric "$@" >out || fail "$1 is $(cat out)"
}
# breaks NAME: times and positions of the Duran plate (003 ch. 7: about 10 us, about 30 us, about 70 mm from its left
# side)
breaks() {
  within "$1: start" 9e-6 11e-6 "$(cell "$1" "start of growth: tip moved by more than a spacing, t")"
  within "$1: branches" 27e-6 33e-6 "$(cell "$1" "branching: fronts apart from then on, t")"
}

duran=$source/cases/duran_50/scene.yaml
go plate "$duran"
breaks plate
within "place" 66.5e-3 73.5e-3 "$(cell plate "branching, x")"
within "top speed" 1000 "$(cell plate "Rayleigh speed")" "$(cell plate "top speed of the tip")"
mirrored plate 0.02 1.0e-3

if thorough; then
  sed -e 's/size: .*/size: [0.12, 0.06]}/; s/  spacing: .*/&\n  lattice_offset: [0.3, 0.7]/' \
    -e 's/\[0, 0\]/[0.0113, 0.0077]/g' \
    -e 's/\[0.1, 0\]/[0.1113, 0.0077]/g; s/\[0, 0.04\]/[0.0113, 0.0477]/g; s/\[0.1, 0.04\]/[0.1113, 0.0477]/g' \
    -e 's/\[0, 0.02\], \[0.05, 0.02\]/[0.0113, 0.0277], [0.0613, 0.0277]/' \
    -e 's/\[0.1, 0.0006\]/[0.1113, 0.0083]/; s/\[0, 0.0394\]/[0.0113, 0.0471]/' \
    "$duran" >moved.yaml
  go moved moved.yaml
  breaks moved
  within "place" 77.8e-3 84.8e-3 "$(cell moved "branching, x")"
  mirrored moved 0.0277 1.0e-3
fi

# with fewer than four substeps the crack branches after 21 to 30 us, and each change of contact changes when
go refined "$source/cases/soda_lime/scene.yaml" --set stages.pull.steps=520 --set output.fields_every=520 \
  --set stages.pull.substeps=6 \
  --set 'solid.refinement={energy: 0.7, from: 5.7e-6, every: 10}'
within "particles" 4400 6500 "$(sed -n 's/.*"particles": *\([0-9]*\).*/\1/p' refined/run.json | head -n 1)"
within "refined: branches" 19e-6 24e-6 "$(cell refined "branching: fronts apart from then on, t")"
mirrored refined 0.02 5.0e-4
echo ok
