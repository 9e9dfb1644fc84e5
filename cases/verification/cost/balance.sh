#!/usr/bin/env bash
# Prints, of the series.csv of a run folder, the last row's sum of the solid's energies, the works, and their ratio.
# usage: balance.sh FOLDER
set -euo pipefail
awk -F, '
  FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
  /^#/ { next }
  function of(name) { return name in at ? $at[name] : 0 }
  { energies = of("e_kinetic_solid") + of("e_strain") + of("e_contact") + of("e_damped") + of("e_fracture")
    works = of("work_fluid") + of("work_load") + of("e_constraint") }
  END { print energies, works, energies / works }' "$1/series.csv"
