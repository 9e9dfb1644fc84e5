#!/usr/bin/env bash
# Draws damage.png, modes.png and curve.png from the runs and the studies' tables.
# usage: cases/verification/impact_disc/draw.sh RUNS RESULTS
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../../common.sh"
here=$(cd "$(dirname "$0")" && pwd)
runs=$1 out=$2
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
{
  cat <<'END'
set terminal pngcairo size 1000,960 font 'DejaVu Sans,12'
set output 'damage.png'
set multiplot layout 2,2 margins 0.05,0.87,0.06,0.96 spacing 0.06,0.09
set size ratio -1
set xrange [-38:38]
set yrange [-38:38]
set cbrange [0:1]
set palette defined (0 '#f7fbff', 0.35 '#fdae61', 0.7 '#b2182b', 1 '#40004b')
set xlabel 'mm' offset 0, 0.7
unset key
unset colorbox
END
  for name in lattice centroidal; do
    for step in 300 600; do
      [ $name.$step != centroidal.600 ] ||
        echo "set colorbox user origin 0.91,0.3 size 0.02,0.4; set cblabel 'damage of the struck face'"
      echo "set title '$name, $((step / 10)) µs'"
      echo "plot '$work/$name.$step' using 1:2:3 with points pointtype 5 pointsize 0.36 linecolor palette"
    done
  done
} | (cd "$out" && gnuplot)

# amplitudes: of a full run, of a study's method
of_run() {
  local k
  for k in $(seq 12); do
    echo "$k $(awk -F, -v what=amplitude -v of="$k" -v step="$2" -f "$here/modes.awk" "$1")"
  done
}
of_study() {
  awk -F, -v m="$2" -v s="_$3" '/^#/ { next }
    !at["value"] { for (i = 1; i <= NF; i++) at[$i] = i; next }
    $1 == m && $4 ~ "^mode[0-9]*" s "$" { k = $4; sub(/^mode/, "", k); sub(/_.*/, "", k)
      print k, $at["value"], $at["value_spread"] + 0 }' "$out/$1.csv" >"$work/$2"
}
of_run "$runs/lattice/modes.csv" 600 >"$work/full.lattice"
of_run "$runs/centroidal/modes.csv" 600 >"$work/full.centroidal"
of_run "$here/lammps_modes.csv" 600 >"$work/full.lammps"
of_study study_axes lattice 400
of_study study_axes hexagonal 400
of_study study_seeds centroidal 400
of_study study_seeds perturbed 400
(cd "$out" && gnuplot) <<END
set terminal pngcairo size 1300,480 font 'DejaVu Sans,12'
set output 'modes.png'
set multiplot layout 1,2
set xlabel 'azimuthal mode'
set ylabel 'amplitude of the damage, over all rings'
set xtics 1
set xrange [0.5:12.5]
set grid linecolor rgb '#dddddd'
set key top left
set title '103,110 particles, 60 µs'
plot '$work/full.lattice' with linespoints pointtype 5 linewidth 2 linecolor rgb '#0072b2' title 'lattice',\
 '$work/full.lammps' with points pointtype 4 pointsize 1.6 linecolor rgb '#000000' title 'lattice, LAMMPS',\
 '$work/full.centroidal' with linespoints pointtype 7 linewidth 2 linecolor rgb '#d55e00' title 'centroidal'
set title '10,758 particles, 40 µs, mean and deviation of ten seeds'
plot '$work/lattice' using 1:2 with linespoints pointtype 5 linewidth 2 linecolor rgb '#0072b2' title 'lattice',\
 '$work/hexagonal' using 1:2 with linespoints pointtype 9 linewidth 2 linecolor rgb '#56b4e9' title 'hexagonal',\
 '$work/perturbed' using (\$1-0.08):2:3 with yerrorlines pointtype 13 linewidth 2 linecolor rgb '#e69f00'\
 title 'perturbed',\
 '$work/centroidal' using (\$1+0.08):2:3 with yerrorlines pointtype 7 linewidth 2 linecolor rgb '#d55e00'\
 title 'centroidal'
END
# curve COLUMN NAME: time in microseconds and a column of series.csv
curve() { awk -F, -v c="$1" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 { print 1e6 * $at["t"], $at[c] }' "$runs/$2/series.csv" >"$work/$2.$1"; }
for name in lattice centroidal; do for column in damage_mean e_kinetic_solid; do curve $column $name; done; done
grep -v '[#s]' "$here/lammps.csv" | tr ',' ' ' >"$work/lammps"
(cd "$out" && gnuplot) <<END
set terminal pngcairo size 1300,440 font 'DejaVu Sans,12'
set output 'curve.png'
set multiplot layout 1,2
set xlabel 'time, µs'
set grid linecolor rgb '#dddddd'
set key top left
set ylabel 'mean damage'
plot '$work/lattice.damage_mean' with lines linewidth 2 linecolor rgb '#0072b2' title 'lattice',\
 '$work/lammps' using (\$1/10):4 with points pointtype 4 linecolor rgb '#000000' title 'lattice, LAMMPS',\
 '$work/centroidal.damage_mean' with lines linewidth 2 linecolor rgb '#d55e00' title 'centroidal'
set ylabel 'kinetic energy, J'
plot '$work/lattice.e_kinetic_solid' with lines linewidth 2 linecolor rgb '#0072b2' title 'lattice',\
 '$work/lammps' using (\$1/10):3 with points pointtype 4 linecolor rgb '#000000' title 'lattice, LAMMPS',\
 '$work/centroidal.e_kinetic_solid' with lines linewidth 2 linecolor rgb '#d55e00' title 'centroidal'
END
