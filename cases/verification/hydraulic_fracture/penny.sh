#!/usr/bin/env bash
# Prints, in a run folder of penny.yaml or penny_viscosity.yaml, one number of the growth of a penny-shaped crack under
# injection, and writes growth.csv: radius, opening in the middle and pressure at the well beside the similarity
# solution of the regime, toughness if not given (physics/hydraulic_fracture.h). In the viscosity regime the pressure at
# the well has none. The radius is that of a circle whose area is the notch's and the crack's.
# The fracture energy is that of a creeping crack in space, $creeping_space G0 (1.328: frana calibrate, m = 3).
# The time of the reference is the injected volume over the rate, so that the ramp of the injection does not count.
# usage: penny.sh length|opening|pressure [REGIME]           mean deviation from the reference
#        penny.sh length_ratio|opening_ratio|pressure_ratio  mean of the ratio to the reference
#        penny.sh length_exponent|opening_exponent           of the power of t, by a line through the logarithms
#        penny.sh energy|grown|residual                      mean of 4 p^2 a/(pi E') over G0; growth in spacings;
#                                                            largest volume residual over the injected volume
#        penny.sh number_least|number_most                   K' (t^2/(mu'^5 Q0^3 E'^13))^(1/18)
#        penny.sh rest_opening|rest_volume                   over Sneddon's, when a thousandth of the area is new
# Means and numbers are over all samples after growth by two spacings, exponents after growth by a quarter of the
# notch's radius.
set -euo pipefail
read -r viscosity rate < <(awk '
  $1 == "viscosity:" { mu = $2 }
  $1 == "rate:" { rate = $2 }
  END { print mu, rate }' scene.resolved.yaml)
awk -F, -v what="$1" -v regime="${2:-toughness}" -v creeping="${creeping_space:-1.328}" -v mu="$viscosity" \
  -v Q0="$rate" -f "$(dirname "$0")/growth.awk" -f - probes.csv series.csv <<'PROGRAM'
BEGIN {
  a0 = 0.012; spacing = 1e-3; G0 = 50; E1 = 2e10 / (1 - 1 / 16)
  K1 = 4 * sqrt(2 / pi) * sqrt(creeping * G0 * E1); m1 = 12 * mu
  print "t,injected,radius,radius_reference,opening,opening_reference,pressure,pressure_reference" >"growth.csv"
  print "#s,m3,m,m,m,m,Pa,Pa" >"growth.csv"
}
file == 1 { u[$k["t"], $k["probe"]] = $k["displacement_z"]; next }
{
  t = $k["t"]; p = $k["injection_pressure"]; V = $k["injected_volume"]
  if (V <= 0 || !((t, 0) in u)) next
  w = opening(t); a = sqrt(a0^2 + $k["crack_area"] / pi)
  single["grown"] = (a - a0) / spacing
  if (w <= 0) next
  if ($k["crack_area"] < 1e-3 * pi * a0^2) {
    single["rest_opening"] = w / (8 * p * a0 / pi / E1); single["rest_volume"] = V / (16 * p * a0^3 / 3 / E1)
  }
  residual_over($k["volume_residual"], V)
  t1 = V / Q0
  if (regime == "viscosity") {
    a1 = 0.69784 * (Q0^3 * E1 * t1^4 / m1)^(1 / 9); w1 = 1.19326 * (m1^2 * Q0^3 * t1 / E1^2)^(1 / 9); p1 = ""
  } else {
    a1 = 0.85464 * (E1 * V / K1)^0.4; w1 = 0.65370 * (K1^4 * V / E1^4)^0.2; p1 = 0.30037 * (K1^6 / (E1 * V))^0.2
  }
  record(t, V, a, a1, w, w1, p, p1)
  if (a < a0 + 2 * spacing) next
  late = a >= 1.25 * a0
  sample("length", a, a1, t1, late); sample("opening", w, w1, t1, late)
  if (p1 != "") sample("pressure", p, p1, t1, late)
  number = exp((log(K1) * 18 + log(t1) * 2 - log(m1) * 5 - log(Q0) * 3 - log(E1) * 13) / 18)
  if (!count) single["number_least"] = number
  single["number_most"] = number
  sum += 4 * p^2 * a / pi / E1 / G0; single["energy"] = sum / ++count
}
END { answer() }
PROGRAM
