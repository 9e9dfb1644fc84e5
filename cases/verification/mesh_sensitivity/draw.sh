#!/usr/bin/env bash
# Draws mesh_sensitivity.png from the studies' tables. usage: cases/verification/mesh_sensitivity/draw.sh [RESULTS]
set -euo pipefail
cd "${1:-$(dirname "$0")/results}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
points() { # points CSV METHOD X: x, value, deviation, wall; x: the number in the level's name
  awk -F, -v m="$2" '/^#/ { next }
    !at["value"] { for (i = 1; i <= NF; i++) at[$i] = i; next }
    $1 == m && $4 == "error_l2" && $at["status"] == "done" {
      x = $2; gsub(/[^0-9.]/, "", x)
      print x, $at["value"], $at["value_spread"] + 0, $at["wall_median_s"] }' "$1.csv" >"$work/$3"
}
n=0
panel() { # panel USING CSV METHOD TITLE ...: a curve each
  local using=$1 parts=()
  shift
  while [ $# -gt 0 ]; do
    points "$1" "$2" $n
    parts+=("'$work/$n' using $using linestyle $4 title '$3'")
    n=$((n + 1))
    shift 4
  done
  (IFS=,; echo "plot ${parts[*]}")
}
curves() { # curves USING GRIDS SEEDS
  panel "$1" "$2" lattice lattice 1 "$2" hexagonal hexagonal 2 "$3" perturbed 'perturbed, 0.2 h' 3 \
    "$3" centroidal centroidal 4 "$3" 'centroidal cells' 'centroidal, volumes of cells' 5 "$3" random random 6
}
{
  cat <<'END'
set terminal pngcairo size 1300,1000 font 'DejaVu Sans,12'
set output 'mesh_sensitivity.png'
set multiplot layout 2,2
set logscale y
set ylabel 'relative L2 error'
set format y '%g'
set grid linecolor rgb '#dddddd'
set key below
set style line 1 linecolor rgb '#0072b2' linewidth 2 pointtype 5
set style line 2 linecolor rgb '#56b4e9' linewidth 2 pointtype 9
set style line 3 linecolor rgb '#e69f00' linewidth 2 pointtype 13
set style line 4 linecolor rgb '#d55e00' linewidth 2 pointtype 7
set style line 5 linecolor rgb '#cc79a7' linewidth 2 pointtype 6
set style line 6 linecolor rgb '#888888' linewidth 2 pointtype 3
set title 'horizon 0.25 m, mean and standard deviation of ten seeds'
set xlabel "horizon over spacing, m\n"
END
  curves '1:2:3 with yerrorlines' study_horizon_grids study_horizon
  printf '%s\n' "set title 'horizon 3 spacings'" "set xlabel \"spacing, m\\n\"" 'set logscale x' "set format x '%g'" \
    'set xtics (0.03, 0.05, 0.08, 0.13)' 'set xrange [0.03:0.15]'
  curves '1:2:3 with yerrorlines' study_points_grids study_points
  printf '%s\n' "set title 'perturbed lattice, horizon 3 spacings'" "set xlabel \"perturbation, spacings\\n\"" \
    'unset logscale x' 'set xtics auto' 'set xrange [0:0.42]'
  panel '1:2:3 with yerrorlines' study_perturbation 'P = 0' 'P = 0' 1 study_perturbation 'P = 1' 'P = 1' 4 \
    study_perturbation 'P = 2' 'P = 2' 3
  printf '%s\n' "set title 'horizon 0.25 m'" "set xlabel \"wall time with the arrangement, s\\n\"" \
    'set logscale x' 'set xtics auto' 'set xrange [*:*]'
  curves '4:2 with points' study_horizon_grids study_horizon
} >"$work/plot.gp"
gnuplot "$work/plot.gp"
