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

# the pressure along the crack, from the fields of the first of these runs
in_profile() { (cd "$runs/runs/$name/-E-s0/1/1" && "$here/profile.sh" "$1"); }
for which in well half; do # at the well and half-way to the tips
  shown "viscosity regime, p_cav = -E s0: pressure from fields, $which: mean of the ratio" 1 \
    "$(kept "profile $which" in_profile $which)" 1 "no toughness"
done
shown "viscosity regime, p_cav = -E s0: pressure half-way to the tips over that at the well" 1 \
  "$(kept "profile fall" in_profile fall)" "$(calc 0.42706/0.54482)" "no toughness"

# other m: the energy that the crack takes beside that of a wedge
for m in 2 4; do
  grown_with() { (cd "$runs/m$m" && "$here/growth.sh" "$1"); }
  run_once m$m toughness.yaml "solid.materials[0].horizon_ratio=$m" \
    'crack_fluid.injections[0].low=[0.1185, 0.110]' 'crack_fluid.injections[0].high=[0.1215, 0.130]'
  wedge=$([ $m = 2 ] && echo 1.919 || echo 1.305)
  shown "toughness regime, m = $m: pi p^2 l/E': energy" G0 "$(kept "m$m energy" grown_with energy)" "$wedge" \
    "frana calibrate"
  for which in energy_least energy_most; do
    shown "toughness regime, m = $m: pi p^2 l/E': ${which/_/, }" G0 "$(kept "m$m $which" grown_with $which)" "$wedge" \
      "frana calibrate"
  done
done

# penny-shaped cracks
in_penny() { (cd "$runs/$1" && "$here/penny.sh" "${@:2}"); }
of_penny() { kept "$1 $2" in_penny "$@"; } # NAME NUMBER [REGIME]
run_once penny penny.yaml
at_most "penny, toughness regime: volume residual over the injected volume" 1 "$(of_penny penny books)" 0 exact 1e-12
near "penny, a = 4 horizons: opening over Sneddon's" 1 "$(of_penny penny rest_opening)" 1 "Sneddon 1946" 0.08
near "penny, a = 4 horizons: volume over Sneddon's" 1 "$(of_penny penny rest_volume)" 1 "Sneddon 1946" 0.08
row "penny, toughness regime: growth that is averaged over" spacings "$(calc "$(of_penny penny grown) - 2")" 10 \
  "asked for" 10
limits=(0.1 0.15 0.2) i=0
for quantity in length opening pressure; do
  at_most "penny, toughness regime: $quantity: mean deviation" 1 "$(of_penny penny $quantity)" 0 exact "${limits[i]}"
  shown "penny, toughness regime: $quantity: mean of the ratio" 1 "$(of_penny penny ${quantity}_ratio)" 1 exact
  i=$((i + 1))
done
shown "penny, toughness regime: 4 p^2 a/(pi E'): energy" G0 "$(of_penny penny energy)" 1.328 \
  "cases/verification/calibration"
shown "penny, toughness regime: K' (t^2/(mu'^5 Q0^3 E'^13))^(1/18), least" 1 "$(of_penny penny number_least)" ">= 3.5" \
  "Savitski and Detournay 2002"

name=penny_viscosity
run_once $name $name.yaml
at_most "penny, viscosity regime: volume residual over the injected volume" 1 "$(of_penny $name books)" 0 exact 1e-12
row "penny, viscosity regime: growth that is averaged over" spacings \
  "$(calc "$(of_penny $name grown) - 2")" 10 "asked for" 10
at_most "penny, viscosity regime: opening: mean deviation" 1 "$(of_penny $name opening viscosity)" 0 "no toughness" \
  0.12
row "penny, viscosity regime: radius: exponent" 1 "$(of_penny $name length_exponent viscosity)" 0.444444444444 4/9 \
  "$(calc 4/9-0.03)" "$(calc 4/9+0.03)"
row "penny, viscosity regime: opening: exponent" 1 "$(of_penny $name opening_exponent viscosity)" 0.111111111111 \
  1/9 "$(calc 1/9-0.03)" "$(calc 1/9+0.03)"
shown "penny, viscosity regime: radius: mean deviation" 1 "$(of_penny $name length viscosity)" 0 "no toughness"
for quantity in length opening; do
  shown "penny, viscosity regime: $quantity: mean of the ratio" 1 "$(of_penny $name ${quantity}_ratio viscosity)" 1 \
    "no toughness"
done
for which in least most; do
  shown "penny, viscosity regime: K' (t^2/(mu'^5 Q0^3 E'^13))^(1/18), $which" 1 \
    "$(of_penny $name number_$which viscosity)" "<= 1" "Savitski and Detournay 2002"
done
for name in penny penny_viscosity; do
  [ "$again" ] || awk 'NR <= 2 || NR % 12 == 0' "$runs/$name/growth.csv" >"$out/$name.csv"
done
finish
