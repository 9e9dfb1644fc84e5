#!/usr/bin/env bash
# The load at which an interface breaks, and the energy that a crack along it takes.
# usage: cases/verification/interface/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study_bar
stress=$(cell study_bar value "one material" 1 stress)
near "bar, one material: stress at which the interface breaks over E s0" 1 "$stress" 1 \
  "E s0 of a bond along the bar" 0.05
near "bar, four times the interface's energy: that stress over the one before" 1 \
  "$(awk -v a="$(cell study_bar value "four times the energy" 1 stress)" -v b="$stress" 'BEGIN { print a / b }')" 2 \
  "s0 goes with the energy's root" 0.02
if [ ! "$quick" ]; then
  study study_strip
  near "strip, the material's own energy: energy out of motion and strain over crack area" G \
    "$(cell study_strip value same 1/2 balance)" 1.188 "fracture_energy: the same strip of one body" 0.001
  near "strip, a weak interface: energy out of motion and strain over crack area" G \
    "$(cell study_strip value weak 1/2 balance)" 1.02801 "bonds across a plane of the lattice" 0.02
  near "strip, two materials: energy out of motion and strain over crack area" G \
    "$(cell study_strip value "two materials" 1/2 balance)" 1.02801 "bonds across a plane of the lattice" 0.05
  for name in same weak "two materials"; do
    shown "strip, $name: energy that bonds released over crack area" G \
      "$(cell study_strip value "$name" 1/2 bonds)" 1.02801 "bonds across a plane of the lattice"
  done
fi
finish
