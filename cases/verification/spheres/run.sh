#!/usr/bin/env bash
# Permeability and tortuosity of simple cubic arrays of spheres, over solid fractions, positions on the grid, time steps
# and methods for the surface.
# usage: cases/verification/spheres/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
source_of() { if [ "$1" = 0.2 ]; then echo "fundamental solutions"; else echo "Zick and Homsy 1982"; fi; }
fractions="0.027 0.064 0.125 0.2 0.216 0.343 0.45"
study study
for c in $fractions; do
  near "c = $c at 32^3: k over the reference" 1 "$(cell study value "$c" 32 permeability)" 1 "$(source_of "$c")" 0.02
done
study study_tortuosity
for c in 0.125 0.343; do
  near "c = $c at 32^3: tortuosity over the reference" 1 "$(cell study_tortuosity value $c 32 tortuosity)" 1 \
    "fundamental solutions" 0.003
done
if [ ! "$quick" ]; then
  study study_place
  spread() { # spread METHOD: of k over the five places, over the least
    awk -F, -v c="$1 at" 'index($1, c) == 1 && $4 == "permeability" {
        if (!n++ || $6 < low) low = $6
        if (n == 1 || $6 > high) high = $6 }
      END { print (high - low) / low }' "$tables/study_place.csv"
  }
  for c in 0.125 0.2 0.45; do
    row "c = $c at 32^3: k's spread over five places on the grid" 1 "$(spread "$c")" 0 "the same body" 0 0.005
  done
  shown "c = 0.2 at 32^3, lattice: k's spread over five places on the grid" 1 "$(spread "0.2 lattice")" 0 \
    "the same body"
  for surface in "" " lattice"; do
    for place in "at a corner" "at a centre" "at .3 .1 .7" "at .25 .6 .4" "at .8 .45 .05"; do
      near "c = 0.2 at 32^3,${surface:- shape} $place: k over the reference" 1 \
        "$(cell study_place value "0.2$surface $place" 32 permeability)" 1 "fundamental solutions" 0.02
    done
  done
  study study_step
  for surface in shape lattice; do
    for step in 4 16; do
      near "c = 0.2 at 32^3, $surface: k at a step of 1/$step" 1 \
        "$(cell study_step value $surface $step permeability)" \
        "$(cell study_step value $surface 1 permeability)" "the longest step" 0.005
    done
  done
  study study_loads
  study study_how
  study study_fine
  for c in $fractions; do
    near "c = $c at 64^3: k over the reference" 1 "$(cell study_fine value "$c" 64 permeability)" 1 \
      "$(source_of "$c")" 0.01
  done
  order() { # order C STUDY COARSE STUDY FINE
    calc "log($(cell "$2" error "$1" "$3" permeability) / $(cell "$4" error "$1" "$5" permeability)) / log($5 / $3)"
  }
  for c in 0.125 0.2; do
    shown "c = $c: order of k from 16^3 to 24^3" 1 "$(order $c study 16 study 24)" 2 "second order"
    shown "c = $c: order of k from 24^3 to 32^3" 1 "$(order $c study 24 study 32)" 2 "second order"
    row "c = $c: order of k from 16^3 to 64^3" 1 "$(order $c study 16 study_fine 64)" 2 "second order" 1.7 2.3
  done
fi
finish
