#!/usr/bin/env bash
# Writes displacement.csv, the displacement in front of the patch by each model; energy_density.csv, the density of
# strain energy along the patch (000: figs 22 to 33); patch.csv, what patch.awk says of the refined particles. draw.gp
# draws them. usage: draw.sh, in the folder of the runs. Needs h5dump (Debian: hdf5-tools).
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../common.sh"
{
  echo "t,uniform,a,b,b_corrected,dual,dual_kept"
  echo "#s,m,m,m,m,m,m"
  awk -F, 'FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i } FNR <= 2 || $k["probe"] != 0 { next }
    file == 1 { n++; line[$k["step"]] = $k["t"] } { line[$k["step"]] = line[$k["step"]] "," $k["displacement_x"] }
    END { for (i = 0; i < n; i++) print line[i] }' {uniform,a,b,b_corrected,dual,dual_kept}/probes.csv
} >displacement.csv
field() { h5_values "$1/fields/solid_00000$2.hdf" "/VTKHDF/$3" %.9g "$4"; } # field RUN STEP DATASET COLUMNS
# places RUN STEP DATASET: the particles' places before they moved, and the dataset
places() {
  paste -d ' ' <(field "$1" "$2" Points 3) <(field "$1" "$2" PointData/displacement 3) \
    <(field "$1" "$2" "PointData/$3" 1) |
    awk '{ printf "%.6g %.6g %s\n", $1 - $4, $2 - $5, $7 }'
}
# profile RUN STEP Y: the particles of a row, as lines RUN,T,Y,X,W with W over the largest of the uniform grid's row.
# The uniform grid has no row at 0.02025 and 0.02275, and a plane wave: its row below is taken.
profile() {
  places "$1" "$2" energy_density | awk -v run="$1" -v t="$(calc "$2 * 2e-4")" -v y="$3" '
      { row = run == "uniform" ? int(y / 5e-4 + 1e-6) * 5e-4 : y; d = $2 - row }
      d * d < 1e-10 && $1 > 0.0399 && $1 < 0.0601 { printf "%s,%g,%g,%.6g,%.6g\n", run, t, y, $1, $3 }' |
    sort -t, -g -k 4
}
{
  echo "run,t,y,x,w"
  echo "#,s,m,m,1"
  for step in 190 220; do
    for y in 0.02 0.02025 0.02275; do for r in uniform a b; do profile $r $step $y; done; done
  done | awk -F, -v OFS=, '$1 == "uniform" { if ($5 > top[$2, $3]) top[$2, $3] = $5 }
    { line[NR] = $0 } END { for (i = 1; i <= NR; i++) { $0 = line[i]; $5 = sprintf("%.5g", $5 / top[$2, $3]); print } }'
} >energy_density.csv
# over_time RUN: place, volume and level of its particles; then, while the pulse is at the patch, energy and velocity
over_time() {
  paste -d ' ' <(places "$1" 170 volume) <(field "$1" 170 PointData/level 1)
  for step in $(seq 170 5 325); do
    echo "#"
    paste -d ' ' <(field "$1" "$step" PointData/energy_density 1) <(field "$1" "$step" PointData/velocity 3)
  done
}
over_time uniform >uniform/over_time
{
  echo "run,x,y,volume,loss,loss_kinetic"
  echo "#,m,m,1,%,%"
  for r in a b b_corrected dual dual_kept; do
    over_time $r | awk -v run=$r -f "$(dirname "$0")/patch.awk" uniform/over_time -
  done
} >patch.csv
