#!/usr/bin/env bash
# Writes displacement.csv, the displacement in front of the patch by each model, and draws reflection.png.
# usage: draw.sh OUT, in the folder of the runs
set -euo pipefail
{
  echo "t,uniform,a,b,b_corrected,dual,dual_kept"
  echo "#s,m,m,m,m,m,m"
  awk -F, 'FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i } FNR <= 2 || $k["probe"] != 0 { next }
    file == 1 { n++; line[$k["step"]] = $k["t"] } { line[$k["step"]] = line[$k["step"]] "," $k["displacement_x"] }
    END { for (i = 0; i < n; i++) print line[i] }' {uniform,a,b,b_corrected,dual,dual_kept}/probes.csv
} >"$1/displacement.csv"
command -v gnuplot >/dev/null || exit 0
cd "$1"
gnuplot <<'GP'
set terminal pngcairo size 900,560
set output "reflection.png"
set datafile separator ","
set xlabel "t, s"
set ylabel "(u - u of the uniform grid) at (0.034, 0.02), % of the pulse"
set key top left
stats "displacement.csv" every ::2 using 2 nooutput
plot for [c=3:7] "displacement.csv" every ::2 using 1:(100*(column(c)-column(2))/STATS_max) \
  with lines lw 1.5 title word("A B B-corrected dual dual-kept", c-2)
GP
