#!/usr/bin/env bash
# The plate turned on the lattice by 0, 15, 30 and 45 degrees, with three horizons, on the lattice in four places and on
# perturbed particles of five seeds. Writes results/turned.csv (each run), turned_spread.csv and turned.png.
# With --points instead on centroidal points of five seeds, and on hexagonal ones turned by 0, 15 and 30 degrees: writes
# results/arrangement.csv and arrangement_spread.csv.
# usage: cases/duran_50/turned.sh [--points] [RUNS]     (runs/duran_50_turned)
#        cases/duran_50/turned.sh [--points] --summary  runs nothing: spread and picture from the first table
# FRANA is the program (build/frana). Finished runs are kept.
# shellcheck disable=SC2034 # of cases/turned.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
table=turned
[ "${1-}" != --points ] || { table=arrangement && shift; }
runs=${1:-runs/duran_50_turned} out=cases/duran_50/results
. cases/turned.sh
title="Duran 50 glass" traction=12.0e6 steps=920
material="youngs_modulus: 65.0e9, density: 2235, fracture_energy: 204"
variants=("lattice 0 0" "lattice 0.25 0" "lattice 0 0.25" "lattice 0.25 0.25"
  "seed 1" "seed 2" "seed 3" "seed 4" "seed 5")
[ "$table" = turned ] || variants=("${arranged[@]}")
fork_study "${variants[@]}"
