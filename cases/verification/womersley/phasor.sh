#!/bin/sh
# Prints the amplitude (times rho w/G, G = rho = 1) or the lag behind cos W t (degrees) of an oscillation of angular
# frequency W, over the last period of a column of a CSV file. Samples are evenly spaced, a whole number of them in a
# period.
# usage: phasor.sh FILE COLUMN W amplitude|lag, in the run folder
awk -F, -v column="$2" -v w="$3" -v what="$4" 'NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i } NR <= 2 { next }
  { n++; t[n] = $k["t"]; u[n] = $k[column] }
  END { pi = atan2(0, -1); m = int(2 * pi / w / (t[n] - t[n - 1]) + 0.5)
    for (i = n - m + 1; i <= n; i++) { a += 2 / m * u[i] * cos(w * t[i]); b += 2 / m * u[i] * sin(w * t[i]) }
    printf "%.14g\n", (what == "lag") ? atan2(b, a) * 180 / pi : w * sqrt(a * a + b * b) }' "$1"
