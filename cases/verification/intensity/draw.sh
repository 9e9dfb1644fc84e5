#!/usr/bin/env bash
# Draws error.png: error of K over run time, with bonds and by element-free Galerkin, from the studies of both cases.
# usage: cases/verification/intensity/draw.sh [OUT]
set -euo pipefail
cd "$(dirname "$0")"
out=${1:-results}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# curve CSV METHOD QUANTITY: wall seconds and error in per cent, one level a line
curve() {
  sed 's/, /; /g' "$1" | awk -F, -v m="$2" -v q="$3" '/^#/ { next }
    !w { for (i = 1; i <= NF; i++) { if ($i == "relative_error") e = i; if ($i == "wall_median_s") w = i }; next }
    { gsub(/"/, "", $1) }
    $1 == m && $4 == q { print $w, 100 * $e }'
}
curve "$out/study.csv" bonds "K by J" >"$work/1"
curve "$out/study.csv" bonds "K by the interaction integral" >"$work/2"
curve ../element_free/results/study.csv "nodes graded about the tip" K | sort -g >"$work/3"
curve ../element_free/results/study.csv "even nodes" K | sort -g >"$work/4"
gnuplot <<GP
set terminal pngcairo size 800,600 font 'DejaVu Sans,12'
set output '$out/error.png'
set logscale xy
set xlabel 'wall time of the steps, or of the solution, s'
set ylabel 'error of K, %'
set format x '%g'
set format y '%g'
set grid linecolor rgb '#dddddd'
set key left bottom
plot '$work/1' with linespoints linewidth 2 pointtype 7 linecolor rgb '#0072b2' \
    title 'bonds, 25, 50, 100 spacings: J', \
  '$work/2' with linespoints linewidth 2 pointtype 6 linecolor rgb '#0072b2' title 'the same: interaction integral', \
  '$work/3' with linespoints linewidth 2 pointtype 5 linecolor rgb '#d55e00' \
    title 'element-free, nodes graded about the tip', \
  '$work/4' with linespoints linewidth 2 pointtype 4 linecolor rgb '#d55e00' title 'element-free, even nodes', \
  0.1 with lines dashtype 2 linecolor rgb '#888888' title 'uncertainty of the reference'
GP
