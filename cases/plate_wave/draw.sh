#!/usr/bin/env bash
# Writes displacement.csv, the displacement in front of the patch by each model, and energy_density.csv, the density of
# strain energy along the patch (000: figs 22 to 33); draw.gp draws both.
# usage: draw.sh OUT, in the folder of the runs. Needs h5dump (Debian: hdf5-tools).
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../common.sh"
{
  echo "t,uniform,a,b,b_corrected,dual,dual_kept"
  echo "#s,m,m,m,m,m,m"
  awk -F, 'FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i } FNR <= 2 || $k["probe"] != 0 { next }
    file == 1 { n++; line[$k["step"]] = $k["t"] } { line[$k["step"]] = line[$k["step"]] "," $k["displacement_x"] }
    END { for (i = 0; i < n; i++) print line[i] }' {uniform,a,b,b_corrected,dual,dual_kept}/probes.csv
} >"$1/displacement.csv"
# profile RUN STEP Y: the particles of a row, as lines RUN,T,Y,X,W with W over the largest of the uniform grid's row.
# The uniform grid has no row at 0.02025 and 0.02275, and a plane wave: its row below is taken.
profile() {
  local field=$1/fields/solid_00000$2.hdf
  paste -d ' ' <(h5_values "$field" /VTKHDF/Points %.9g 3) \
    <(h5_values "$field" /VTKHDF/PointData/displacement %.9g 3) \
    <(h5_values "$field" /VTKHDF/PointData/energy_density %.9g 1) |
    awk -v run="$1" -v t="$(calc "$2 * 2e-4")" -v y="$3" '
      { row = run == "uniform" ? int(y / 5e-4 + 1e-6) * 5e-4 : y; x = $1 - $4; d = $2 - $5 - row }
      d * d < 1e-10 && x > 0.0399 && x < 0.0601 { printf "%s,%g,%g,%.6g,%.6g\n", run, t, y, x, $7 }' |
    sort -t, -g -k 4
}
{
  echo "run,t,y,x,w"
  echo "#,s,m,m,1"
  for step in 190 220; do
    for y in 0.02 0.02025 0.02275; do for r in uniform a b; do profile $r $step $y; done; done
  done | awk -F, -v OFS=, '$1 == "uniform" { if ($5 > top[$2, $3]) top[$2, $3] = $5 }
    { line[NR] = $0 } END { for (i = 1; i <= NR; i++) { $0 = line[i]; $5 = sprintf("%.5g", $5 / top[$2, $3]); print } }'
} >"$1/energy_density.csv"
