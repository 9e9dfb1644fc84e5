#!/usr/bin/env bash
# Prints, in a run folder, one number of a crack's growth under injection, and writes growth.csv: half length, opening
# in the middle and pressure at the well beside the similarity solution of the scene's regime
# (physics/hydraulic_fracture.h).
# The fracture energy is that of a creeping crack, $creeping G0 (1.437723138: frana calibrate, m = 3 in a plate).
# The time of the reference is the injected volume over the rate, so that the ramp of the injection does not count.
# usage: growth.sh length|opening|pressure          mean deviation from the reference
#        growth.sh length_ratio|...                 mean of the ratio to the reference
#        growth.sh length_exponent|...              of the power of t, by a straight line through the logarithms
#        growth.sh energy|energy_least|energy_most  pi p^2 l/E' over G0, with p at the well
#        growth.sh grown                            half length less the notch's, in spacings
#        growth.sh rest_opening|rest_volume         over Sneddon's, in the last sample before a bond breaks
#        growth.sh toughness|residual|broken        K'/(mu' E'^3 Q0)^(1/4); largest volume residual over the injected
#                                                   volume; bonds broken a spacing of both tips' way
# Ratios, deviations and energies are over all samples after growth by a quarter of the notch's half length, exponents
# after its doubling.
set -euo pipefail
read -r modulus ratio energy thickness spacing viscosity rate notch < <(awk '
  { gsub(/[][,]/, " ") }
  $1 == "youngs_modulus:" { modulus = $2 }
  $1 == "poisson_ratio:" { ratio = $2 }
  $1 == "fracture_energy:" { energy = $2 }
  $1 == "thickness:" { thickness = $2 }
  $1 == "spacing:" { spacing = $2 }
  $1 == "viscosity:" { viscosity = $2 }
  $1 == "rate:" { rate = $2 }
  $1 == "cracks:" { cracks = 1 }
  cracks && $1 == "-" && $2 ~ /^[0-9]/ && n < 2 { x[++n] = $2; y[n] = $3 }
  END { print modulus, ratio, energy, thickness, spacing, viscosity, rate, sqrt((x[2] - x[1])^2 + (y[2] - y[1])^2) / 2 }
  ' scene.resolved.yaml)
awk -F, -v what="$1" -v creeping="${creeping:-1.437723138}" -v E="$modulus" -v nu="$ratio" -v G0="$energy" \
  -v thickness="$thickness" -v spacing="$spacing" -v mu="$viscosity" -v rate="$rate" -v a0="$notch" \
  -f "$(dirname "$0")/growth.awk" -f - crack_particles.csv probes.csv series.csv <<'PROGRAM'
BEGIN {
  E1 = E / (1 - nu^2); K1 = 4 * sqrt(2 / pi) * sqrt(creeping * G0 * E1); m1 = 12 * mu; Q0 = rate / thickness
  number = single["toughness"] = K1 / power(m1 * E1^3 * Q0, 0.25)
  if (number > 1 && number < 4) fail("between the regimes: " number)
  print "t,injected,length,length_reference,opening,opening_reference,pressure,pressure_reference" >"growth.csv"
  print "#s,m2,m,m,m,m,Pa,Pa" >"growth.csv"
}
file == 1 { # both ends, by the time
  t = $k["t"]; x = $k["x"]
  if (!(t in low) || x < low[t]) low[t] = x
  if (!(t in high) || x > high[t]) high[t] = x
  next
}
file == 2 { u[$k["t"], $k["probe"]] = $k["displacement_y"]; next }
{
  t = $k["t"]; p = $k["injection_pressure"]; volume = $k["injected_volume"] / thickness
  if (FNR == 3) {
    for (s in low) if (s + 0 == 0) { left = left0 = low[s]; right = right0 = high[s] }
    broken0 = $k["bonds_broken"]
  }
  if ((t in low) && low[t] < left) left = low[t]
  if ((t in high) && high[t] > right) right = high[t]
  if (volume <= 0 || !((t, 0) in u) || opening(t) <= 0) next
  l = a0 + (right - right0 + left0 - left) / 2
  w = opening(t)
  if ($k["bonds_broken"] == broken0) {
    single["rest_opening"] = w / (4 * p * a0 / E1); single["rest_volume"] = volume / (2 * pi * p * a0^2 / E1)
  }
  residual_over($k["volume_residual"], $k["injected_volume"])
  single["grown"] = (l - a0) / spacing
  single["broken"] = ($k["bonds_broken"] - broken0) / (2 * (l - a0) / spacing + (l == a0))
  time = volume / Q0
  if (number >= 4) {
    l1 = 0.93239 * power(E1 * volume / K1, 2 / 3); w1 = 0.68278 * power(K1^2 * volume / E1^2, 1 / 3)
    p1 = 0.18307 * power(K1^4 / (E1 * volume), 1 / 3)
  } else {
    l1 = 0.61541 * power(Q0^3 * E1 * time^4 / m1, 1 / 6); w1 = 1.12583 * power(m1 * Q0^3 * time^2 / E1, 1 / 6)
    p1 = 0.54482 * power(m1 * E1^2 / time, 1 / 3)
  }
  record(t, volume, l, l1, w, w1, p, p1)
  if (l < 1.25 * a0) next
  late = l >= 2 * a0
  sample("length", l, l1, time, late); sample("opening", w, w1, time, late); sample("pressure", p, p1, time, late)
  g = pi * p^2 * l / E1 / G0; sum += g; single["energy"] = sum / ++count
  if (count == 1 || g < single["energy_least"]) single["energy_least"] = g
  if (g > single["energy_most"]) single["energy_most"] = g
}
END { if (!failed) answer() }
PROGRAM
