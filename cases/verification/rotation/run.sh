#!/usr/bin/env bash
# A free sphere in a shear flow: how fast it turns, over the grid, the density, the stiffness and the surface.
# usage: cases/verification/rotation/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
what='rate of turning over the shear rate'
study study
for method in lattice shape light heavy stiff; do
  near "$method, 10 cells a diameter: $what" 1 "$(cell study value $method 10 "$what")" 0.5 "Jeffery 1922" 0.03
done
[ "$quick" ] || {
  study study_fine
  for method in lattice shape; do
    near "$method, 20 cells a diameter: $what" 1 "$(cell study_fine value $method 20 "$what")" 0.5 "Jeffery 1922" 0.01
  done
}
finish
