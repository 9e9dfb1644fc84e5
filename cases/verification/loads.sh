#!/usr/bin/env bash
# Draws loads.png: error against run time of the default load and of the thesis's probe, from the results of four cases.
# usage: cases/verification/loads.sh
set -euo pipefail
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
curve() { # curve CSV METHOD QUANTITY: wall seconds and relative error, one level a line
  awk -F, -v m="$2" -v q="$3" '/^#/ { next }
    !w { for (i = 1; i <= NF; i++) { if ($i == "relative_error") e = i; if ($i == "wall_median_s") w = i }; next }
    $1 == m && $4 == q && $e > 0 { print $w, 100 * $e }' "$1" | sort -g
}
panel() { # panel TITLE CSV QUANTITY METHOD LABEL ...
  local title=$1 csv=$2 quantity=$3 parts=() n=0
  shift 3
  while [ $# -gt 0 ]; do
    curve "$csv" "$1" "$quantity" >"$work/$panels.$n"
    parts+=("'$work/$panels.$n' using 1:2 with linespoints linestyle $((n + 1)) title '$2'")
    n=$((n + 1))
    shift 2
  done
  echo "set title '$title'"
  (IFS=,; echo "plot ${parts[*]}")
  panels=$((panels + 1))
}
panels=0
{
  cat <<'END'
set terminal pngcairo size 1200,900 font 'Sans,13'
set output 'loads.png'
set multiplot layout 2,2
set logscale xy
set xlabel 'wall time of the steps, s' offset 0, 0.7
set ylabel 'relative error, %'
set format y '%g'
set format x '%g'
set grid linecolor rgb '#dddddd'
set key below
set style line 1 linecolor rgb '#0072b2' linewidth 2 pointtype 7 pointsize 1.2
set style line 2 linecolor rgb '#d55e00' linewidth 2 pointtype 5 pointsize 1.2
set style line 3 linecolor rgb '#56b4e9' linewidth 2 pointtype 6 pointsize 1.2 dashtype 2
set style line 4 linecolor rgb '#e69f00' linewidth 2 pointtype 4 pointsize 1.2 dashtype 2
END
  panel 'Permeability of spheres, 16 to 48 cells a period' spheres/results/study_loads.csv permeability \
    'reaction lattice' 'reaction, lattice' 'probe lattice' 'multidirect, lattice' \
    'reaction shape' 'reaction, shape' 'probe shape' 'multidirect, shape'
  panel 'Drag of a sphere by its load, 8 to 32 cells a diameter' \
    sphere_drag/results/study_loads.csv 'drag by the load' reaction reaction probe probe
  panel 'Speed of a settling sphere, 6 and 12 cells' ten_cate/results/study_loads.csv 'largest speed over u_inf' \
    reaction reaction probe probe
  panel 'Main case: bonds broken at 8 ms, 2 to 1/4 steps' ../porous_channel/results/study_loads.csv 'share broken' \
    reaction reaction probe probe
} >"$work/loads.gp"
gnuplot "$work/loads.gp"
