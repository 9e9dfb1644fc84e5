#!/usr/bin/env bash
# Prints, in a run folder of well.yaml, one number of two parallel cracks that one well feeds, and writes growth.csv:
# half lengths, pressure at the well, and the pressure at which K_I = K_IC at the longer crack beside the shorter one of
# its first length.
# The fracture energy is that of a creeping crack, $creeping G0 (1.4377: frana calibrate, m = 3 in a plate).
# usage: well.sh longer|shorter            growth of a wing in spacings, the mean of both
#        well.sh first                     largest pressure over that at which K_I = K_IC at the longer crack
#        well.sh pressure|pressure_ratio   mean deviation from that pressure, mean of the ratio, over all samples after
#                                          growth by 3 mm
#        well.sh residual                  largest volume residual over the injected volume
set -euo pipefail
awk -F, -v what="$1" -v creeping="${creeping:-1.4377}" '
  function factor(l,  i) { # K_I/(p sqrt(pi l)) of the longer crack: interaction.py 80 0,0,10 0,16,L
    for (i = 2; i < rows && at[i] < l; i++) {}
    return f[i - 1] + (f[i] - f[i - 1]) * (l - at[i - 1]) / (at[i] - at[i - 1])
  }
  function half(row) { return (right[row] - left[row]) / 2 }
  BEGIN {
    pi = atan2(0, -1); E1 = 2e10 / (1 - 1 / 16); K = sqrt(creeping * 50 * E1); a[1] = 0.01; a[2] = 0.014
    rows = split("0.014 0.016 0.018 0.02 0.024 0.028 0.032 0.036", at, " ")
    split("0.90888 0.93952 0.96086 0.97504 0.98994 0.99585 0.99820 0.99918", f, " ")
    print "t,injected,shorter,longer,pressure,pressure_reference" >"growth.csv"
    print "#s,m2,m,m,Pa,Pa" >"growth.csv"
  }
  FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
  FNR <= 2 { next }
  file == 1 { # crack_particles.csv: both ends of both cracks, by the time; between them is the slit
    t = $k["t"] + 0; x = $k["x"]; row = $k["y"] < 0.12 ? 1 : 2
    if (!((t, row) in low) || x < low[t, row]) low[t, row] = x
    if (!((t, row) in high) || x > high[t, row]) high[t, row] = x
    next
  }
  { # series.csv
    t = $k["t"] + 0; p = $k["injection_pressure"]; volume = $k["injected_volume"] / 1e-3
    for (row = 1; row <= 2; row++) {
      if (FNR == 3) { left[row] = low[0, row]; right[row] = high[0, row]; begin[row] = half(row) }
      if ((t, row) in low && low[t, row] < left[row]) left[row] = low[t, row]
      if ((t, row) in high && high[t, row] > right[row]) right[row] = high[t, row]
      l[row] = a[row] + half(row) - begin[row]
    }
    if (volume <= 0) next
    reference = K / sqrt(pi * l[2]) / factor(l[2])
    printf "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", t, volume, l[1], l[2], p, reference >"growth.csv"
    residual = $k["volume_residual"] / $k["injected_volume"]
    if (residual < 0) residual = -residual
    if (residual > worst) worst = residual
    if (p / reference > most) most = p / reference
    if (l[2] < a[2] + 0.003) next
    n++; ratio += p / reference; off += p > reference ? p / reference - 1 : 1 - p / reference
  }
  END {
    if (what == "longer") printf "%.2f\n", (l[2] - a[2]) / 1e-3
    else if (what == "shorter") printf "%.2f\n", (l[1] - a[1]) / 1e-3 + 1e-9
    else if (what == "first") print most
    else if (what == "residual") print worst
    else if (!n) { print "the crack has not grown" >"/dev/stderr"; exit 1 }
    else if (what == "pressure") print off / n
    else print ratio / n
  }' crack_particles.csv series.csv
