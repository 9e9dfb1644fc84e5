#!/usr/bin/env bash
# A body that moves with the flow has no load. A sphere in a fluid at rest has its weight minus its buoyancy.
# usage: cases/verification/rest_and_galilean/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
broken() { (cd "$runs/runs/$1/1" && "$here/final.sh" broken); }
study study_driven
study study_free
study study_hydrostatic
for case in driven free; do
  for method in lattice shape; do
    for level in 16 24; do
      for what in "largest load" "largest forcing" "strain energy" slip; do
        row "$case, $method, $level cells: $what" 1 "$(cell study_$case value $method $level "$what")" 0 \
          "one velocity for all" 0 1e-8
      done
      row "$case, $method, $level cells: broken bonds" 1 \
        "$(kept "$case, $method, $level cells: broken bonds" broken "study_$case/$method/$level")" 0 \
        "one velocity for all" 0 0
    done
  done
done
# The fluid of the box has momentum 1. The sphere's 463 particles have twice the density of the fluid that they replace,
# so they add the mass of 463 cells of fluid.
near "free, balanced, 24 cells: velocity in the end" m/s "$(cell study_free value balanced 24 velocity)" \
  "$(calc "1 / (1 + 463 / 24 ^ 3)")" "momentum of fluid and sphere" 1e-9
near "balanced, 20 cells a diameter: buoyancy" N "$(cell study_hydrostatic value balanced 20 buoyancy)" 5235.98776 \
  "rho g V" 0.01
for method in lattice shape; do
  shown "free, $method, 24 cells: velocity in the end" m/s "$(cell study_free value $method 24 velocity)" 0.9351858 \
    "momentum of the fluid outside and of the solid"
  for level in 10 20; do
    tolerance=$([ $level = 10 ] && echo 0.03 || echo 0.015)
    near "$method, $level cells a diameter: buoyancy" N "$(cell study_hydrostatic value $method $level buoyancy)" \
      5235.98776 "rho g V" "$tolerance"
    near "$method without retraction, $level cells a diameter: buoyancy" N \
      "$(cell study_hydrostatic value "$method without retraction" $level buoyancy)" 5235.98776 "rho g V" \
      "$tolerance"
    row "$method, $level cells a diameter: force of the forcing over the buoyancy" 1 \
      "$(calc "$(cell study_hydrostatic value $method $level forcing) / 5235.98776")" 0 "a fluid at rest" -1e-8 1e-8
  done
  row "$method: order of the buoyancy" 1 "$(cell study_hydrostatic order $method 20 buoyancy)" 1 \
    "first order of the retraction; a lattice's depth adds one of second" 0.7 \
    "$([ "$method" = lattice ] && echo 1.5 || echo 1.3)"
done
finish
