#!/usr/bin/env bash
# Permeability of body-centred and face-centred cubic arrays of spheres and of hexagonal arrays of cylinders, and the
# tortuosity of these, from bodies that are written with one sphere or cylinder a site.
# usage: cases/verification/arrays/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study_hexagonal
for c in 0.1 0.2 0.4; do
  for n in 41 56; do
    near "hexagonal, c = $c at $n cells a row: k over the reference" 1 \
      "$(cell study_hexagonal value "hexagonal $c" $n permeability)" 1 "fundamental solutions" 0.02
    near "hexagonal, c = $c at $n cells a row: tortuosity over the reference" 1 \
      "$(cell study_hexagonal value "hexagonal $c" $n tortuosity)" 1 "fundamental solutions" 0.003
  done
done
if [ ! "$quick" ]; then
  study study
  for array in "BCC 0.1" "BCC 0.2" "BCC 0.3" "FCC 0.1" "FCC 0.2" "FCC 0.4"; do
    shown "${array/ /, c = } at 24^3: k over the reference" 1 "$(cell study value "$array" 24 permeability)" 1 \
      "fundamental solutions"
    near "${array/ /, c = } at 48^3: k over the reference" 1 "$(cell study value "$array" 48 permeability)" 1 \
      "fundamental solutions" 0.02
  done
fi
finish
