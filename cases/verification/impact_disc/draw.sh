#!/usr/bin/env bash
# Draws damage.png, modes.png and curve.png from the runs and the studies' tables, by draw.gp.
# usage: cases/verification/impact_disc/draw.sh RUNS RESULTS     needs h5dump (Debian: hdf5-tools)
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../../common.sh"
here=$(cd "$(dirname "$0")" && pwd)
runs=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# top NAME STEP: places before displacement and damage of the top layer: x z damage, mm
top() {
  local file
  file=$runs/$1/fields/solid_$(printf %08d "$2").hdf
  paste -d ' ' <(h5_values "$file" /VTKHDF/Points %.9g 3) \
    <(h5_values "$file" /VTKHDF/PointData/displacement %.9g 3) <(h5_values "$file" /VTKHDF/PointData/damage %.9g 1) |
    awk '$2 - $5 > 0.01475 { printf "%.4f %.4f %.4f\n", 1e3 * ($1 - $4) - 40, 1e3 * ($3 - $6) - 40, $7 }' \
      >"$work/$1.$2"
}
for name in lattice centroidal; do for step in 300 600; do top $name $step; done; done
for table in lattice=$runs/lattice/modes.csv centroidal=$runs/centroidal/modes.csv lammps=$here/lammps_modes.csv; do
  for k in $(seq 12); do
    echo "$k $(awk -F, -v what=amplitude -v of="$k" -v step=600 -f "$here/modes.awk" "${table#*=}")"
  done >"$work/full.${table%%=*}"
done
cd "$2" && gnuplot -c "$here/draw.gp" "$work" "$here" "$runs"
