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
  for method in lattice shape probe; do
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
# The fluid of the box has momentum 1. The sphere's 463 particles have twice the density of the fluid that they replace.
# Load by reaction: the inner fluid belongs to nobody, so the fluid outside, of momentum 1 - f, and the sphere, of mass
# 2 f, share a velocity; f is the sphere's share of the box. Balanced: the sphere's mass is added to the whole fluid's.
f=$(calc "463 / 24 ^ 3")
near "free, lattice, 24 cells: velocity in the end" m/s "$(cell study_free value lattice 24 velocity)" \
  "$(calc "(1 - $f) / (1 + $f)")" "momentum of the fluid outside and of the solid" 1e-9
near "free, balanced, 24 cells: velocity in the end" m/s "$(cell study_free value balanced 24 velocity)" \
  "$(calc "1 / (1 + $f)")" "momentum of fluid and sphere" 1e-9
for method in shape probe; do
  shown "free, $method, 24 cells: velocity in the end" m/s "$(cell study_free value $method 24 velocity)" 0.9351858 \
    "momentum of the fluid outside and of the solid"
done
for method in lattice shape "probe on the lattice" "probe on the shape" "probe without retraction" wall balanced; do
  for level in 10 20; do
    tolerance=$([ $level = 10 ] && echo 0.03 || echo 0.015)
    near "$method, $level cells a diameter: buoyancy" N "$(cell study_hydrostatic value "$method" $level buoyancy)" \
      5235.98776 "rho g V" "$tolerance"
  done
done
for method in lattice shape; do
  for level in 10 20; do
    row "$method, $level cells a diameter: force of the forcing over the buoyancy" 1 \
      "$(calc "$(cell study_hydrostatic value $method $level forcing) / 5235.98776")" 0 "a fluid at rest" -1e-8 1e-8
  done
done
finish
