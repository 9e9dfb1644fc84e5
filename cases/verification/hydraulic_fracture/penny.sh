#!/usr/bin/env bash
# Prints, in a run folder of penny.yaml, one number of the growth of a penny-shaped crack under injection, and writes
# growth.csv: radius, opening in the middle and pressure at the well beside the similarity solution of the toughness
# regime (physics/hydraulic_fracture.h). The radius is that of a circle whose area is the notch's and the crack's.
# The fracture energy is that of a creeping crack in space, $creeping_space G0 (1.328: frana calibrate, m = 3).
# usage: penny.sh length|opening|pressure                          mean deviation from the reference
#        penny.sh length_ratio|opening_ratio|pressure_ratio        mean of the ratio to the reference
#        penny.sh energy|grown|books                               mean of 4 p^2 a/(pi E') over G0; growth in spacings;
#                                                                  largest volume residual over the injected volume
#        penny.sh rest_opening|rest_volume                         over Sneddon's, when a thousandth of the area is new
# Means are over all samples after growth by two spacings.
set -euo pipefail
awk -F, -v what="$1" -v creeping="${creeping_space:-1.328}" '
  function abs(x) { return x < 0 ? -x : x }
  function sample(name, ours, exact) { n[name]++; off[name] += abs(ours / exact - 1); ratio[name] += ours / exact }
  BEGIN {
    pi = atan2(0, -1); a0 = 0.012; spacing = 1e-3; G0 = 50; E1 = 2e10 / (1 - 1 / 16)
    K1 = 4 * sqrt(2 / pi) * sqrt(creeping * G0 * E1)
    print "t,injected,radius,radius_reference,opening,opening_reference,pressure,pressure_reference" >"growth.csv"
    print "#s,m3,m,m,m,m,Pa,Pa" >"growth.csv"
  }
  FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
  FNR <= 2 { next }
  file == 1 { u[$k["t"], $k["probe"]] = $k["displacement_z"]; next }
  {
    t = $k["t"]; p = $k["injection_pressure"]; V = $k["injected_volume"]
    if (V <= 0 || !((t, 0) in u)) next
    w = u[t, 0] - u[t, 1]; a = sqrt(a0^2 + $k["crack_area"] / pi)
    if (w <= 0) next
    if ($k["crack_area"] < 1e-3 * pi * a0^2) {
      rest["rest_opening"] = w / (8 * p * a0 / pi / E1); rest["rest_volume"] = V / (16 * p * a0^3 / 3 / E1)
    }
    books = abs($k["volume_residual"] / V)
    if (books > worst) worst = books
    a1 = 0.85464 * (E1 * V / K1)^0.4; w1 = 0.65370 * (K1^4 * V / E1^4)^0.2; p1 = 0.30037 * (K1^6 / (E1 * V))^0.2
    printf "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", t, V, a, a1, w, w1, p, p1 >"growth.csv"
    if (a < a0 + 2 * spacing) next
    sample("length", a, a1); sample("opening", w, w1); sample("pressure", p, p1)
    sum += 4 * p^2 * a / pi / E1 / G0; count++
  }
  END {
    name = what; sub(/_.*/, "", name)
    if (what == "grown") print (a - a0) / spacing
    else if (what == "books") print worst
    else if (what in rest) print rest[what]
    else if (!count) { print "the crack has not grown" > "/dev/stderr"; exit 1 }
    else if (what == "energy") print sum / count
    else if (what ~ /_ratio$/) print ratio[name] / n[name]
    else print off[name] / n[name]
  }' probes.csv series.csv
