#!/usr/bin/env bash
# Prints the scene of Mandel's slab |x| <= a: columns of particles between smooth stiff plates that press it with a
# constant force, of which the outer two are drained. Each row is moved along y as the plates' exact displacement asks
# for and is free along x; so the reactions of the rows are a result. The height is 1.5 times the width: the ends, whose
# families are not whole, hardly count in the middle.
# usage: mandel.sh HALF BIOT MODULUS PERMEABILITY NU STEPS    HALF: a, spacings; STEPS: of the stage that drains
# or:    mandel.sh HALF BIOT MODULUS PERMEABILITY NU series T    prints p/p0 in the middle of an isotropic body
# or:    mandel.sh HALF BIOT MODULUS PERMEABILITY NU number T pressure|reaction|sealed
#        reads a run in the present folder, writes slab.csv and prints the pressure in the middle at T over that of
#        the sealed slab, the reaction over the load, or the pressure of the sealed slab over that of the solution
# Stresses of a cubic lattice in a plate, C1 = C11, C2 = C12, S = 1/M + alpha^2/C1, b = alpha (1 - C2/C1),
# D = C1 - C2^2/C1:
#     D e - b mean(p) = -F ,  S p + b e = content     along y: strain e, mean stress -F; no stress along x
#     p = p0 2 sum of sin(B)/(B - sin B cos B) (cos(B x/a) - cos B) exp(-B^2 T),  tan B = eta B,  eta = 1 + S D/b^2
#     p0 = F/(D S/b + b),  T = c (t - start)/a^2,  c = k/(mu S)
# This is Mandel's solution; an isotropic body of Poisson's ratio 1/4 has C1 = 1.2 E, C2 = 0.4 E.
# series: of such a body of the ratio NU.
set -euo pipefail
# shellcheck source=cases/verification/consolidation/interpolate.sh
. "$(dirname "$0")/interpolate.sh"
solution='
  function root(i,  low, high, B) { # of tan B = eta B in (i pi, (i + 1/2) pi)
    low = i * pi + (i ? 0 : 0.1); high = (i + 0.5) * pi
    for (;;) {
      B = 0.5 * (low + high)
      if (B <= low || B >= high) return B
      if ((i % 2 ? -1 : 1) * (sin(B) - eta * B * cos(B)) < 0) low = B; else high = B
    }
  }
  function sum_of(T, mean,  i, B, sum) { # p/p0 in the middle, or its mean over the slab
    for (i = 0; i < ROOTS; i++) {
      B = beta[i]
      sum += 2 * sin(B) / (B - sin(B) * cos(B)) * ((mean ? sin(B) / B : 1) - cos(B)) * exp(-B * B * T)
    }
    return sum
  }
  function strain(T) { return (b * p0 * (T > 0 ? sum_of(T, 1) : 1) - load) / D }
  BEGIN {
    pi = atan2(0, -1); h = 1e-3; HIGH = 3 * HALF; a = HALF * h; E = 2e10; load = 3e6; ROOTS = 100
    lattice(E, NU, isotropic)
    S = (modulus == ".inf" ? 0 : 1 / modulus) + biot^2 / C1; b = biot * (1 - C2 / C1); D = C1 - C2 * C2 / C1
    eta = 1 + S * D / (b * b); p0 = load / (D * S / b + b); period = a * a * S * 1e-3 / k0
    wave = a / 3200; dt = 4e-7
    pressed = 12 * wave; sealed = dt * int(18 * wave / dt + 0.5); opened = sealed + wave; start = sealed + wave / 2
    for (i = 0; i < ROOTS; i++) beta[i] = root(i)
  }'
scene=(-v HALF="$1" -v biot="$2" -v modulus="$3" -v k0="$4" -v NU="$5")
if [ "$6" = series ]; then
  awk "${scene[@]}" -v isotropic=1 -v T="$7" "$moduli$solution"'BEGIN { printf "%.6g\n", sum_of(T, 0) }'
  exit
fi
if [ "$6" = number ]; then
  awk -F, "${scene[@]}" -v T="$7" -v what="$8" "$interpolate$moduli$solution"'
    BEGIN {
      print "T,pressure,pressure_reference,reaction" >"slab.csv"
      print "#1,1,1,1" >"slab.csv"
    }
    FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
    FNR <= 2 { next }
    file == 1 { if ($k["load"] == 0 && $k["index"] >= HIGH / 2) upper[$k["t"]] -= $k["force_y"]; next }
    {
      t = $k["t"]; p = $k["injection_pressure"] / p0; F = upper[t] / (load * 2 * a * h)
      if (t < sealed + 0.5 * dt) of_sealed = p
      now = (t - start) / period
      if (now > 0.002) printf "%.6g,%.6g,%.6g,%.6g\n", now, p, sum_of(now, 0), F >"slab.csv"
      take("pressure", p); take("reaction", F)
      was = now
    }
    END {
      value["sealed"] = of_sealed
      print_taken(what)
    }' reactions.csv series.csv
  exit
fi
awk "${scene[@]}" -v steps="$6" "$moduli$solution"'
  BEGIN {
    wide = (2 * HALF + 1) * h; high = HIGH * h; POINTS = 60; RAMP = 20; damping = 0.2 / wave
    until = (sealed + steps * dt - start) / period
    time = given = "[0, 0]"
    for (i = 1; i <= RAMP; i++) {
      t = pressed * i / RAMP; factor = 0.5 * (1 - cos(pi * i / RAMP))
      time = time sprintf(", [%.9g, %.9g]", t, factor * strain(0)); given = given sprintf(", [%.9g, %.9g]", t, factor)
    }
    time = time sprintf(", [%g, %.9g]", start, strain(0)); given = given sprintf(", [%g, 1], [%g, 0]", sealed, opened)
    for (i = 1; i <= POINTS; i++) {
      T = until * (i / POINTS)^2
      time = time sprintf(", [%.9g, %.9g]", start + T * period, strain(T))
    }
    print "title: A porous slab between two plates that drains at both sides (Mandel)"
    printf "domain: {size: [%g, %g]}\n", wide, high
    print "solid:\n  spacing: 1.0e-3\n  model: plane_strain\n  thickness: 1.0e-3"
    printf "  materials: [{name: rock, youngs_modulus: 2.0e10, poisson_ratio: %g, density: 2500}]\n", NU
    printf "  bodies: [{shape: rectangle, low: [0, 0], high: [%g, %g]}]\n", wide, high
    print "  contact: {enabled: false}\n  constraints: # displacement: distance from the middle; factor: strain"
    for (j = 0; j < HIGH; j++)
      printf "    - {low: [0, %g], high: [%g, %g], directions: y, displacement: [0, %g], time: [%s]}\n",
        j * h, wide, (j + 1) * h, (j + 0.5) * h - 0.5 * high, time
    print "crack_fluid:\n  viscosity: 1.0e-3\n  least_aperture: 1.0e-8\n  least_pressure: -1.0e9"
    printf "  pores: {permeability: %s, biot: %s, modulus: %s}\n", k0, biot, modulus
    print "  injections: # of the first one injection_pressure is written: in the middle"
    printf "    - {low: [%g, %g], high: [%g, %g], rate: 0}\n", HALF * h, 0.5 * high - h, (HALF + 1) * h, 0.5 * high + h
    drained = sprintf("pressure: %.9g, time: [%s]", p0, given)
    printf "    - {low: [0, 0], high: [%g, %g], %s}\n", h, high, drained
    printf "    - {low: [%g, 0], high: [%g, %g], %s}\n", wide - h, wide, high, drained
    stage = "  - {name: %s, steps: %d, time_step: %g, integrator: verlet, damping_absolute: %g, crack_fluid: true}\n"
    printf "stages:\n"
    printf stage, "press", sealed / dt + 0.5, dt, damping
    printf stage, "drain", steps, dt, damping
    print "output: {series_every: 15, checkpoint_every: 0, fields_every: 0, stress: false}"
  }'
