#!/usr/bin/env bash
# The energy that a crack takes while it runs through a strip.
# usage: cases/verification/fracture_energy/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
if [ "$quick" ]; then name=study levels="1/2 1/4" finest=1/4 tolerance=0.1; else name=study_fine levels="1/2 1/4 1/8" \
  finest=1/8 tolerance=0.05; fi
study $name
for level in $levels; do
  judge=(shown)
  [ "$level" != 1/8 ] || judge=(near 0.05)
  "${judge[0]}" "step $level: energy out of motion and strain over crack area" G0 \
    "$(cell $name value Verlet "$level" balance)" 1.02801 "bonds across a plane of the lattice" "${judge[@]:1}"
  shown "step $level: energy that bonds released over crack area" G0 \
    "$(cell $name value Verlet "$level" bonds)" 1.02801 "bonds across a plane of the lattice"
done
near "step $finest: energy that bonds released over what went out of motion and strain" 1 \
  "$(cell $name value Verlet $finest bonds)" "$(cell $name value Verlet $finest balance)" "energy balance" $tolerance
row "order in time of the gap between the two" 1 "$(cell $name order Verlet $finest gap)" 2 \
  "velocity Verlet" 1.6 2.6
row "step $finest: speed of the tip" "sqrt(E/density)" "$(cell $name value Verlet $finest speed)" "below 0.5630" \
  "Rayleigh's wave" 0 0.5630
finish
