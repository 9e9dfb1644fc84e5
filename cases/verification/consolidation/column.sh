#!/usr/bin/env bash
# Reads a run of terzaghi.yaml in the present folder: writes column.csv, the pressure at the base over that of the
# sealed column and the part of the settlement that has come, beside Terzaghi's series, and prints them at one T.
# usage: column.sh BIOT MODULUS PERMEABILITY NU T pressure|settlement|sealed
# T = c (t - start)/H^2, c = k/mu/(1/M + alpha^2/K), with the lattice's modulus K of confined compression.
set -euo pipefail
# shellcheck source=cases/verification/consolidation/interpolate.sh
. "$(dirname "$0")/interpolate.sh"
awk -F, -v biot="$1" -v modulus="$2" -v k0="$3" -v NU="$4" -v T="$5" -v what="$6" "$interpolate$moduli"'
  function pressure(T,  m, M, sum) {
    for (m = 0; m < 200; m++) { M = pi / 2 * (2 * m + 1); sum += 2 / M * sin(M) * exp(-M * M * T) }
    return sum
  }
  function degree(T,  m, M, sum) {
    for (m = 0; m < 2000; m++) { M = pi / 2 * (2 * m + 1); sum += 2 / (M * M) * exp(-M * M * T) }
    return 1 - sum
  }
  BEGIN {
    pi = atan2(0, -1); H = 0.032; load = 3e6; lattice(2e10, NU); K = C1
    S = (modulus == ".inf" ? 0 : 1 / modulus) + biot^2 / K
    period = H * H * S * 1e-3 / k0; sealed = 3e-4; start = 3.05e-4; undrained = load * biot / K / S
    print "T,pressure,pressure_reference,settlement,settlement_reference" >"column.csv"
    print "#1,1,1,1,1" >"column.csv"
  }
  FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
  FNR <= 2 { next }
  file == 1 { u[$k["t"], $k["probe"]] = $k["displacement_y"]; next }
  {
    t = $k["t"]
    short = u[t, 0] - u[t, 1]; p = $k["injection_pressure"] / undrained
    if (t < sealed * (1 + 1e-9)) { first = short; of_sealed = p }
    now = (t - start) / period; U = (short - first) / (load * 2 * H / K - first)
    if (now > 0.005) printf "%.6g,%.6g,%.6g,%.6g,%.6g\n", now, p, pressure(now), U, degree(now) >"column.csv"
    take("pressure", p); take("settlement", U)
    was = now
  }
  END {
    value["sealed"] = of_sealed
    print_taken(what)
  }' probes.csv series.csv
