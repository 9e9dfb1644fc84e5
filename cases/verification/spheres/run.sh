#!/usr/bin/env bash
# Permeability and tortuosity of simple cubic arrays of spheres, over solid fractions, positions on the grid and methods
# for the surface.
# usage: cases/verification/spheres/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
fractions="0.027 0.064 0.125 0.216 0.343 0.45"
study study
for c in $fractions; do
  near "c = $c at 32^3: k over the reference" 1 "$(cell study value "$c" 32 permeability)" 1 "Zick and Homsy 1982" 0.03
done
study study_tortuosity
for c in 0.125 0.343; do
  near "c = $c at 32^3: tortuosity over the reference" 1 "$(cell study_tortuosity value $c 32 tortuosity)" 1 \
    "fundamental solutions" 0.003
done
if [ ! "$quick" ]; then
  study study_place
  for c in 0.125 0.45; do
    spread=$(awk -F, -v c="$c" 'index($1, c) == 1 && $4 == "permeability" {
        if (!n++ || $6 < low) low = $6
        if (n == 1 || $6 > high) high = $6 }
      END { print (high - low) / low }' "$tables/study_place.csv")
    row "c = $c at 32^3: k's spread over five places on the grid" 1 "$spread" 0 "the same body" 0 0.005
  done
  study study_how
  study study_fine
  for c in $fractions; do
    near "c = $c at 64^3: k over the reference" 1 "$(cell study_fine value "$c" 64 permeability)" 1 \
      "Zick and Homsy 1982" 0.01
  done
  row "c = 0.125: order of k from 16^3 to 64^3" 1 \
    "$(calc "log($(cell study error 0.125 16 permeability) / $(
      cell study_fine error 0.125 64 permeability)) / log(4)")" 2 "second order" 1.7 2.3
fi
finish
