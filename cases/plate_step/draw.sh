#!/usr/bin/env bash
# Writes energy.csv, the total energy by each model, and draws energy.png. usage: draw.sh OUT, in the folder of the runs
set -euo pipefail
{
  echo "t,uniform,uniform_fine,b,b_corrected,dual,dual_kept"
  echo "#s,J,J,J,J,J,J"
  awk -F, 'FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i } FNR <= 2 { next }
    file == 1 { step[++n] = $k["step"]; line[$k["step"]] = $k["t"] }
    { line[$k["step"]] = line[$k["step"]] sprintf(",%.8g", $k["e_kinetic_solid"] + $k["e_strain"]) }
    END { for (i = 1; i <= n; i++) print line[step[i]] }' \
    {uniform,uniform_fine,b,b_corrected,dual,dual_kept}/series.csv
} >"$1/energy.csv"
command -v gnuplot >/dev/null || exit 0
cd "$1"
gnuplot <<'GP'
set terminal pngcairo size 900,560
set output "energy.png"
set datafile separator ","
set xlabel "t, s"
set ylabel "(energy of the uniform coarse grid - energy)/its largest, %"
stats "energy.csv" every ::2 using 2 nooutput
plot for [c=4:7] "energy.csv" every ::2 using 1:(100*(column(2)-column(c))/STATS_max) \
  with lines lw 1.5 title word("B B-corrected dual dual-kept", c-3)
GP
