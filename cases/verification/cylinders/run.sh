#!/usr/bin/env bash
# Permeability and tortuosity of square arrays of cylinders in cross flow.
# usage: cases/verification/cylinders/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study
for c in 0.1 0.2 0.4 0.5; do
  near "c = $c at 32^2: k over the reference" 1 "$(cell study value $c 32 permeability)" 1 "Sangani and Acrivos 1982" \
    0.03
  near "c = $c at 32^2: tortuosity over the reference" 1 "$(cell study value $c 32 tortuosity)" 1 \
    "fundamental solutions" 0.003
done
if [ ! "$quick" ]; then
  study study_how
  study study_fine
  for c in 0.2 0.4; do
    near "c = $c at 64^2: k over the reference" 1 "$(cell study_fine value $c 64 permeability)" 1 \
      "Sangani and Acrivos 1982" 0.01
    shown "c = $c at 128^2: k over the reference" 1 "$(cell study_fine value $c 128 permeability)" 1 \
      "Sangani and Acrivos 1982"
    near "c = $c at 128^2: tortuosity over the reference" 1 "$(cell study_fine value $c 128 tortuosity)" 1 \
      "fundamental solutions" 0.003
  done
fi
finish
