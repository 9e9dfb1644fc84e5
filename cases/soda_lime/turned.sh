#!/usr/bin/env bash
# The plate turned on the lattice by 0, 15, 30 and 45 degrees, with three horizons, on the lattice and on perturbed
# particles of five seeds. Writes results/turned.csv (each run), turned_spread.csv and turned.png.
# With --points instead on centroidal points of five seeds, and on hexagonal ones turned by 0, 15 and 30 degrees: writes
# results/arrangement.csv and arrangement_spread.csv.
# usage: cases/soda_lime/turned.sh [--points] [RUNS]     (runs/soda_lime_turned)
#        cases/soda_lime/turned.sh [--points] --summary  runs nothing: spread and picture from the first table
# FRANA is the program (build/frana). Finished runs are kept.
# shellcheck disable=SC2034 # of cases/turned.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
table=turned
[ "${1-}" != --points ] || { table=arrangement && shift; }
runs=${1:-runs/soda_lime_turned} out=cases/soda_lime/results
. cases/turned.sh
title="Soda-lime glass" traction=13.442e6 steps=1000
material="youngs_modulus: 72.0e9, density: 2440, fracture_energy: 135"
variants=("lattice 0 0" "seed 1" "seed 2" "seed 3" "seed 4" "seed 5")
[ "$table" = turned ] || variants=("${arranged[@]}")
fork_study "${variants[@]}"
