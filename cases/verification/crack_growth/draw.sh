#!/usr/bin/env bash
# Draws paths.png: the crack near a hole by the maximum hoop stress and with bonds, opened slowly and pulled at once.
# usage: cases/verification/crack_growth/draw.sh RUNS OUT
set -euo pipefail
runs=$1 out=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
awk -F, 'NR > 2 { print 1e3 * $3, 1e3 * $4 }' "$runs/hole/growth.csv" >"$work/hole"
for name in bonds pulled; do
  awk -F, 'NR > 2 { p = 1e3 * $3 " " 1e3 * $4; if (p != last) print p; last = p }' \
    "$runs/$name/crack.csv" >"$work/$name"
done
gnuplot <<GP
set terminal pngcairo size 860,700 font 'DejaVu Sans,12'
set output '$out/paths.png'
set size ratio -1
set xrange [0:30]
set yrange [0:24]
set xlabel 'x, mm'
set ylabel 'y, mm'
set grid linecolor rgb '#eeeeee'
set key top left
set object 1 circle at 20,8 size 4 fillcolor rgb '#dddddd' fillstyle solid border linecolor rgb '#5a6068'
set arrow 1 from 0,15 to 10,15 nohead linewidth 3 linecolor rgb '#23282e'
set label 1 'crack at the start' at 1,14.3
set label 2 'hole' at 20,8 center
plot '$work/hole' with linespoints linewidth 2 pointtype 7 linecolor rgb '#d55e00' \
    title 'maximum hoop stress, element-free, opened slowly', \
  '$work/bonds' with linespoints linewidth 2 pointtype 5 linecolor rgb '#0072b2' \
    title 'bonds, opened slowly (horizon 1.5 mm)', \
  '$work/pulled' with linespoints linewidth 1 pointtype 4 pointsize 0.6 dashtype 2 linecolor rgb '#009e73' \
    title 'bonds, pulled at once by 22 MPa'
GP
