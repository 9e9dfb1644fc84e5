#!/usr/bin/env bash
# Prints, in a run folder, one number of a notched borehole (collocation.py) that is pumped up, and writes record.csv:
# length of a crack, pressure of the fluid and the pressure of linear elasticity at this length.
# The fracture energy is that of a creeping crack, $creeping G0 (1.4377: frana calibrate, m = 3 in a plate).
# usage: borehole.sh breakdown|breakdown_ratio   the largest pressure; over that at which K_I = K_IC at the notches'
#                                                length
#        borehole.sh pressure|pressure_ratio     mean deviation from the pressure at which K_I = K_IC, mean of the ratio
#        borehole.sh grown                       growth of a crack in spacings
#        borehole.sh energy_begin|residual|cavity  K_I^2/(E' G0) at breakdown; largest volume residual over the injected
#                                                volume; void over the volume at breakdown
#        borehole.sh rest                        pressure before the injection
#        borehole.sh volume                      of a hole without notches over linear elasticity's, at the last sample
# Means are over all samples after growth by 3 mm. The stress of $along Pa, tension positive, acts along the notches,
# and the compression $confined Pa in both directions; pressures are less $confined.
set -euo pipefail
read -r notch spacing < <(awk '
  { gsub(/[][,]/, " ") }
  $1 == "spacing:" { spacing = $2 }
  $1 == "cracks:" { cracks = 1 }
  cracks && $1 == "-" && $2 ~ /^[0-9]/ && n < 2 { x[++n] = $2 }
  END { print (x[2] > x[1] ? x[2] - x[1] : x[1] - x[2]), spacing }' scene.resolved.yaml)
factors=$(cd "$(dirname "$0")" && pwd)/factors.csv
awk -F, -v what="$1" -v creeping="${creeping:-1.4377}" -v along="${along:-0}" -v confined="${confined:-0}" \
  -v a0="$notch" -v spacing="$spacing" '
  function factor(column, ratio,  i) { # between the rows of factors.csv
    for (i = 2; i < rows && at[i] < ratio; i++) {}
    return f[column, i - 1] + (f[column, i] - f[column, i - 1]) * (ratio - at[i - 1]) / (at[i] - at[i - 1])
  }
  function strength(a) { # the pressure at which K_I = K_IC
    return (K / sqrt(pi * a) - along * factor("along", a / R)) / factor("pressure", a / R)
  }
  BEGIN {
    pi = atan2(0, -1); R = 0.012; E = 2e10; E1 = E / (1 - 1 / 16); G0 = 50; thickness = 1e-3
    K = sqrt(creeping * G0 * E1)
    print "t,injected,length,pressure,pressure_reference" >"record.csv"
    print "#s,m2,m,Pa,Pa" >"record.csv"
  }
  FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
  file == 1 {
    if (FNR == 1) next
    at[++rows] = $1; f["along", rows] = $k["along"]; f["pressure", rows] = $k["pressure"]
    next
  }
  FNR <= 2 { next }
  file == 2 { # crack_particles.csv: both ends, by the time
    t = $k["t"]; x = $k["x"]
    if (!(t in low) || x < low[t]) low[t] = x
    if (!(t in high) || x > high[t]) high[t] = x
    next
  }
  {
    t = $k["t"]; p = $k["injection_pressure"] - confined; volume = $k["injected_volume"] / thickness
    if (FNR == 3)
      for (s in low) if (s + 0 == 0) { left = left0 = low[s]; right = right0 = high[s] }
    if ((t in low) && low[t] < left) left = low[t]
    if ((t in high) && high[t] > right) right = high[t]
    if (volume <= 0) { rest = p; next }
    a = a0 + (right - right0 + left0 - left) / 2
    if (p > most) { most = p; void = $k["cavity_volume"] / $k["crack_volume"] }
    residual = $k["volume_residual"] / $k["injected_volume"]
    if (residual < 0) residual = -residual
    if (residual > worst) worst = residual
    last = volume / (2 * pi * R^2 * p * 1.875 / E)
    if (a0 <= 2 * spacing) next
    reference = strength(a)
    printf "%.6g,%.6g,%.6g,%.6g,%.6g\n", t, volume, a, p, reference >"record.csv"
    if (a < a0 + 3 * spacing) next
    n++; ratio += p / reference; off += p > reference ? p / reference - 1 : 1 - p / reference
  }
  END {
    if (what == "breakdown") print most
    else if (what == "rest") print rest
    else if (what == "breakdown_ratio") print most / strength(a0)
    else if (what == "energy_begin")
      print (most * factor("pressure", a0 / R) + along * factor("along", a0 / R))^2 * pi * a0 / E1 / G0
    else if (what == "grown") print (a - a0) / spacing
    else if (what == "residual") print worst
    else if (what == "cavity") print void
    else if (what == "volume") print last
    else if (!n) { print "the crack has not grown" >"/dev/stderr"; exit 1 }
    else if (what == "pressure") print off / n
    else print ratio / n
  }' "$factors" crack_particles.csv series.csv
