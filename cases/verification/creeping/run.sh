#!/usr/bin/env bash
# Implicit compared with explicit diffusion at a Reynolds number of 1e-3: the permeability, and the wall time until it
# is reached.
# usage: cases/verification/creeping/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study
k() { cell study value "$1" "$2" permeability; }
seconds() { cell study value "$1" "$2" 'wall time to steady'; }
for n in 16 32; do
  for d in 10 100 1000; do
    near "$n cells: implicit at nu dt/dx^2 = $d over explicit" 1 "$(k "implicit $d" $n)" "$(k explicit $n)" \
      "explicit at its viscous limit" 0.01
  done
  near "$n cells: k at nu dt/dx^2 = 10 over 1000" 1 "$(k 'implicit 10' $n)" "$(k 'implicit 1000' $n)" "no step in it" \
    5e-4
done
near "32 cells: permeability" m2 "$(k 'implicit 1000' 32)" 3.98542e-6 "Zick and Homsy 1982" 0.03
row "32 cells: explicit over implicit, wall time to 0.1 %" 1 \
  "$(calc "$(seconds explicit 32) / $(seconds 'implicit 1000' 32)")" 10 "at least tenfold" 10 1e6
finish
