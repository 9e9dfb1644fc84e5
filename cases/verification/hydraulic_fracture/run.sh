#!/usr/bin/env bash
# A straight crack that a fluid drives through a plate (KGD), in the toughness and in the viscosity regime, and before
# it grows, aligned with the lattice and inclined.
# usage: cases/verification/hydraulic_fracture/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# in_run STUDY METHOD LEVEL NUMBER: a number of growth.sh of a study's run
in_run() { (cd "$runs/runs/$1/$2/$3/1" && "$here/growth.sh" "$4"); }
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
# static NAME STUDY METHOD LEVEL JUDGE [TOLERANCE]: the notch before it grows
static() {
  local judge=("$5")
  [ -z "${6-}" ] || judge=("$5" "$6")
  "${judge[0]}" "$1: opening over 4 p a/E'" 1 "$(cell "$2" value "$3" "$4" "opening at rest")" 1 "Sneddon 1946" \
    "${judge[@]:1}"
  "${judge[0]}" "$1: volume over 2 pi p a^2/E'" 1 "$(cell "$2" value "$3" "$4" "volume at rest")" 1 "Sneddon 1946" \
    "${judge[@]:1}"
}

if [ "$quick" ]; then # twice the tolerance at a spacing of 1 mm
  study study_toughness
  static "notch, a = 2 horizons" study_toughness "m = 3" 2 near 0.1
  at_most "toughness regime, 2 mm: length: mean deviation" 1 "$(cell study_toughness value "m = 3" 2 length)" 0 exact 0.2
  at_most "toughness regime, 2 mm: opening: mean deviation" 1 "$(cell study_toughness value "m = 3" 2 opening)" 0 exact \
    0.3
  at_most "toughness regime, 2 mm: pressure: mean deviation" 1 "$(cell study_toughness value "m = 3" 2 pressure)" 0 \
    exact 0.4
  at_most "toughness regime, 2 mm: volume residual over the injected volume" 1 \
    "$(cell study_toughness value "m = 3" 2 books)" 0 exact 1e-12
  finish
  exit
fi

creeping=$(kept creeping taken)
export creeping
near "creeping crack in plane strain, frana calibrate" G0 "$creeping" 1.437754695 "cases/verification/calibration" 0.01
study study_toughness_fine
name=study_toughness_fine
static "notch, a = 4 horizons" $name "m = 3" 1 near 0.05
static "notch, a = 2 horizons" $name "m = 3" 2 shown
study study_inclined
for angle in 15 30 45; do
  shown "notch at $angle degrees to the lattice, a = 4 horizons: volume over 2 pi p a^2/E'" 1 \
    "$(cell study_inclined value "$angle deg" 1 "volume at rest")" 1 "Sneddon 1946"
done
row "toughness regime, 1 mm: growth that is averaged over" spacings \
  "$(calc "$(kept "toughness grown" in_run $name m---3 1 grown) - 3")" 10 "asked for" 10
at_most "toughness regime, 1 mm: length: mean deviation" 1 "$(cell $name value "m = 3" 1 length)" 0 exact 0.1
at_most "toughness regime, 1 mm: opening: mean deviation" 1 "$(cell $name value "m = 3" 1 opening)" 0 exact 0.15
at_most "toughness regime, 1 mm: pressure: mean deviation" 1 "$(cell $name value "m = 3" 1 pressure)" 0 exact 0.2
for level in 2 1; do
  at_most "toughness regime, $level mm: volume residual over the injected volume" 1 \
    "$(cell $name value "m = 3" $level books)" 0 exact 1e-12
  for quantity in length opening pressure; do
    [ $level = 1 ] ||
      shown "toughness regime, $level mm: $quantity: mean deviation" 1 "$(cell $name value "m = 3" $level $quantity)" 0 \
        exact
    shown "toughness regime, $level mm: $quantity: mean of the ratio" 1 \
      "$(cell $name value "m = 3" $level "$quantity ratio")" 1 exact
  done
  shown "toughness regime, $level mm: energy release rate: mean" G0 "$(cell $name value "m = 3" $level energy)" \
    "$creeping" "frana calibrate"
  shown "toughness regime, $level mm: energy release rate: least" G0 \
    "$(cell $name value "m = 3" $level "energy least")" "$creeping" "frana calibrate"
  shown "toughness regime, $level mm: energy release rate: largest" G0 \
    "$(cell $name value "m = 3" $level "energy most")" "$creeping" "frana calibrate"
done
shown "toughness regime: K'/(mu' E'^3 Q0)^(1/4)" 1 "$(kept "toughness number" in_run $name m---3 1 toughness)" ">= 4" \
  "Detournay 2004"
sparse $name m---3 1 toughness

name=study_viscosity
study $name
at_most "viscosity regime, p_cav = -E s0: opening: mean deviation" 1 "$(cell $name value "-E s0" 1 opening)" 0 \
  "no toughness" 0.12
for pressure in "-E s0" 0; do
  for quantity in length opening; do
    exponent=2/3
    [ $quantity = length ] || exponent=1/3
    centre=$(calc $exponent)
    value=$(cell $name value "$pressure" 1 "$quantity exponent")
    if [ "$pressure" = 0 ]; then
      shown "viscosity regime, p_cav = 0: $quantity: exponent" 1 "$value" "$centre" $exponent
    else
      row "viscosity regime, p_cav = $pressure: $quantity: exponent" 1 "$value" "$centre" $exponent \
        "$(calc "$exponent - 0.03")" "$(calc "$exponent + 0.03")"
    fi
  done
  shown "viscosity regime, p_cav = $pressure: pressure at the well: exponent" 1 \
    "$(cell $name value "$pressure" 1 "pressure exponent")" -0.333333333333 -1/3
  for quantity in length opening pressure; do
    [ "$quantity $pressure" = "opening -E s0" ] ||
      shown "viscosity regime, p_cav = $pressure: $quantity: mean deviation" 1 \
        "$(cell $name value "$pressure" 1 $quantity)" 0 "no toughness"
  done
  at_most "viscosity regime, p_cav = $pressure: volume residual over the injected volume" 1 \
    "$(cell $name value "$pressure" 1 books)" 0 exact 1e-12
done
shown "viscosity regime, p_cav = -E s0: bonds broken a spacing" 1 \
  "$(kept "viscosity broken" in_run $name -E-s0 1 broken)" 36 "a clean plane"
shown "viscosity regime, p_cav = 0: bonds broken a spacing" 1 "$(kept "viscosity broken 0" in_run $name 0 1 broken)" 36 \
  "a clean plane"
shown "viscosity regime: K'/(mu' E'^3 Q0)^(1/4)" 1 "$(kept "viscosity number" in_run $name -E-s0 1 toughness)" "<= 1" \
  "Detournay 2004"
sparse $name -E-s0 1 viscosity
finish
