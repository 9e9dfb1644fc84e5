#!/bin/sh
# Prints a measure of displacement_x of the bar's face, from probes.csv in the run folder:
#   frequency  from the first to the last of its zero crossings, rad/s
#   ratio      the frequency over the exact one of the bar with its column; $DRY is the frequency without the fluid at
#              1000 kg/m3
#   growth     largest displacement before the last crossing over the largest after the first, to a power that makes it
#              the growth of one period
#   late       largest displacement of the second half of the run over that of the first
#   across     the same of displacement_y, which starts at 0 and is round-off unless it grows
# usage: swing.sh frequency|ratio|growth|late|across
solid=$(sed -n '/^solid/,$s/.*density: *\([0-9.e+-]*\).*/\1/p' scene.resolved.yaml | head -n 1)
fluid=$(sed -n '/^fluid/,/^solid/s/.*density: *\([0-9.e+-]*\).*/\1/p' scene.resolved.yaml | head -n 1)
awk -F, -v what="$1" -v dry="${DRY:-0}" -v solid="$solid" -v fluid="${fluid:-0}" '
  function exact(  low, high, q, k) { # q tan q = rho_s l/(rho_f L_f), l = 16 mm, L_f = 48 mm
    low = 0; high = pi / 2
    for (k = 0; k < 60; k++) { q = (low + high) / 2
      if (q * sin(q) / cos(q) > solid * 16 / (fluid * 48)) high = q; else low = q }
    return dry * sqrt(1000 / solid) * q / (pi / 2) }
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR <= 2 { next }
  { t = $at["t"]; x = $at[what == "across" ? "displacement_y" : "displacement_x"]
    if (x * last < 0) { n++; zero[n] = was + (t - was) * last / (last - x) }
    y = x < 0 ? -x : x; if (y > top[n]) top[n] = y
    xs[++samples] = y
    last = x; was = t }
  END { pi = atan2(0, -1); if (what == "late" || what == "across") {
      for (k = 1; k <= samples; k++) { half = k > samples / 2; if (xs[k] > most[half]) most[half] = xs[k] }
      printf "%.6g\n", most[1] / most[0]; exit }
    if (n < 4) exit 1
    w = pi * (n - 1) / (zero[n] - zero[1])
    if (what == "growth") print (top[n - 1] / top[1]) ^ (2 / (n - 2))
    else printf "%.10g\n", what == "ratio" ? w / exact() : w }' probes.csv
