#!/usr/bin/env bash
# A straight crack that a fluid drives through a plate (KGD), in the toughness and in the viscosity regime, and before
# it grows, aligned with the lattice and inclined; a penny-shaped one in a block, in the toughness regime.
# usage: cases/verification/hydraulic_fracture/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# number_of STUDY METHOD LEVEL NUMBER: a number of growth.sh of a study's run; kept
in_run() { (cd "$runs/runs/$1/$2/$3/1" && "$here/growth.sh" "$4"); }
number_of() { kept "$1 $2 $3 $4" in_run "$@"; }
# sparse STUDY METHOD LEVEL NAME: every twelfth sample of growth.csv, stored beside the summary
sparse() {
  [ ! "$again" ] || return 0
  awk 'NR <= 2 || NR % 12 == 0' "$runs/runs/$1/$2/$3/1/growth.csv" >"$out/$4.csv"
}
# taken: what a creeping crack takes, over G0
taken() {
  local dir=$runs/calibration
  [ ! -d "$dir" ] || [ -z "$(find "$dir" -name run.json ! -newer "$frana")" ] || rm -rf "$dir"
  "$frana" calibrate "$here/toughness.yaml" --only creeping --out "$dir" --quiet >"$runs/calibration.log" 2>&1 ||
    { cat "$runs/calibration.log" >&2; return 1; }
  awk -F, '$2 == "creeping_crack" && $3 == "[100]" { print $4; found = 1 } END { exit !found }' "$dir/calibration.csv"
}
# static NAME STUDY LEVEL JUDGE [TOLERANCE]: the notch before it grows
static() {
  local which
  for which in opening volume; do
    "$4" "$1: $which over Sneddon's" 1 "$(cell "$2" value "m = 3" "$3" "$which at rest")" 1 "Sneddon 1946" "${@:5}"
  done
}

if [ "$quick" ]; then # twice the tolerances at a spacing of 1 mm
  name=study_toughness level=2 limits=(0.2 0.3 0.4)
else
  name=study_toughness_fine level=1 limits=(0.1 0.15 0.2)
  creeping=$(kept creeping taken)
  export creeping
  near "creeping crack in plane strain, frana calibrate" G0 "$creeping" 1.437754695 "cases/verification/calibration" \
    0.01
fi
study $name
if [ "$quick" ]; then
  static "notch, a = 2 horizons" $name 2 near 0.1
else
  static "notch, a = 4 horizons" $name 1 near 0.05
  static "notch, a = 2 horizons" $name 2 shown
  static "notch, a = 6 horizons" $name 2/3 shown
fi
i=0
for quantity in length opening pressure; do
  at_most "toughness regime, $level mm: $quantity: mean deviation" 1 "$(cell $name value "m = 3" $level $quantity)" 0 \
    exact "${limits[i]}"
  i=$((i + 1))
done
at_most "toughness regime, $level mm: volume residual over the injected volume" 1 \
  "$(number_of $name m---3 $level books)" 0 exact 1e-12
if [ "$quick" ]; then
  finish
  exit
fi
row "toughness regime, 1 mm: growth that is averaged over" spacings \
  "$(calc "$(number_of $name m---3 1 grown) - 3")" 10 "asked for" 10
for level in 2 2/3; do
  for quantity in length opening pressure; do
    shown "toughness regime, $level mm: $quantity: mean deviation" 1 "$(cell $name value "m = 3" $level $quantity)" 0 \
      exact
  done
done
for level in 2 1 2-3; do
  for quantity in length opening pressure; do
    shown "toughness regime, ${level/-//} mm: $quantity: mean of the ratio" 1 \
      "$(number_of $name m---3 $level ${quantity}_ratio)" 1 exact
  done
  for which in energy energy_least energy_most; do
    shown "toughness regime, ${level/-//} mm: pi p^2 l/E': ${which/_/, }" G0 "$(number_of $name m---3 $level $which)" \
      "$creeping" "frana calibrate"
  done
done
shown "toughness regime: K'/(mu' E'^3 Q0)^(1/4)" 1 "$(number_of $name m---3 1 toughness)" ">= 4" "Detournay 2004"
sparse $name m---3 1 toughness

study study_inclined
for angle in 15 30 45; do
  shown "notch at $angle degrees to the lattice, a = 4 horizons: volume over Sneddon's" 1 \
    "$(cell study_inclined value "$angle deg" 1 "volume at rest")" 1 "Sneddon 1946"
done

name=study_viscosity
study $name
at_most "viscosity regime, p_cav = -E s0: opening: mean deviation" 1 "$(cell $name value "-E s0" 1 opening)" 0 \
  "no toughness" 0.12
row "viscosity regime, p_cav = -E s0: length: exponent" 1 "$(cell $name value "-E s0" 1 "length exponent")" \
  0.666666666667 2/3 "$(calc 2/3-0.03)" "$(calc 2/3+0.03)"
row "viscosity regime, p_cav = -E s0: opening: exponent" 1 "$(cell $name value "-E s0" 1 "opening exponent")" \
  0.333333333333 1/3 "$(calc 1/3-0.03)" "$(calc 1/3+0.03)"
# viscous WHAT METHOD FOLDER: numbers of a run; the folder is the method's name with - for other characters
viscous() {
  local quantity
  at_most "viscosity regime, $1: volume residual over the injected volume" 1 "$(number_of $name "$3" 1 books)" 0 exact \
    1e-12
  for quantity in length opening pressure; do
    shown "viscosity regime, $1: $quantity: mean of the ratio" 1 "$(number_of $name "$3" 1 ${quantity}_ratio)" 1 \
      "no toughness"
  done
  if [ "$2" != "-E s0" ]; then
    shown "viscosity regime, $1: opening: mean deviation" 1 "$(cell $name value "$2" 1 opening)" 0 "no toughness"
    shown "viscosity regime, $1: length: exponent" 1 "$(cell $name value "$2" 1 "length exponent")" 0.666666666667 2/3
    shown "viscosity regime, $1: opening: exponent" 1 "$(cell $name value "$2" 1 "opening exponent")" 0.333333333333 \
      1/3
  fi
  shown "viscosity regime, $1: pressure at the well: exponent" 1 "$(number_of $name "$3" 1 pressure_exponent)" \
    -0.333333333333 -1/3
  shown "viscosity regime, $1: bonds broken a spacing" 1 "$(number_of $name "$3" 1 broken)" 36 "a clean plane"
}
viscous "p_cav = -E s0" "-E s0" -E-s0
viscous "p_cav = 0" 0 0
viscous "p_cav = -E s0, plate of 0.36 m" "-E s0 wide" -E-s0-wide
viscous "p_cav = -E s0, 2/3 mm" "-E s0 2/3 mm" -E-s0-2-3-mm
shown "viscosity regime: K'/(mu' E'^3 Q0)^(1/4)" 1 "$(number_of $name -E-s0 1 toughness)" "<= 1" "Detournay 2004"
sparse $name -E-s0 1 viscosity

# penny: runs the penny-shaped crack; a run that this frana has made is not made again
penny() {
  local dir=$runs/penny
  [ ! "$again" ] || return 0
  ! is_done "$dir" || [ "$dir/run.json" -ot "$frana" ] || return 0
  rm -rf "$dir"
  "$frana" run "$here/penny.yaml" --quiet --out "$dir" >"$runs/penny.log" 2>&1 || { cat "$runs/penny.log" >&2; exit 1; }
}
in_penny() { (cd "$runs/penny" && "$here/penny.sh" "$1"); }
of_penny() { kept "penny $1" in_penny "$1"; }
penny
at_most "penny, toughness regime: volume residual over the injected volume" 1 "$(of_penny books)" 0 exact 1e-12
near "penny, a = 4 horizons: opening over Sneddon's" 1 "$(of_penny rest_opening)" 1 "Sneddon 1946" 0.08
near "penny, a = 4 horizons: volume over Sneddon's" 1 "$(of_penny rest_volume)" 1 "Sneddon 1946" 0.08
shown "penny, toughness regime: growth" spacings "$(of_penny grown)" "" ""
for quantity in length opening pressure; do
  shown "penny, toughness regime: $quantity: mean deviation" 1 "$(of_penny $quantity)" 0 exact
  shown "penny, toughness regime: $quantity: mean of the ratio" 1 "$(of_penny ${quantity}_ratio)" 1 exact
done
shown "penny, toughness regime: 4 p^2 a/(pi E'): energy" G0 "$(of_penny energy)" 1.328 "cases/verification/calibration"
finish
