#!/usr/bin/env bash
# Prints one of Stokes' two numbers of the run in this folder: the fluid's force on the sphere over 6 pi mu a U, in
# phase with the velocity or with the acceleration, over the last whole period.
# usage: phasor.sh forcing|load velocity|acceleration NU
# The forcing's force is the mean of a step: that of a step that ends at t is the force at t - dt/2. So is the load
# `reaction`; the loads of the probes are of the end. The forcing also accelerates the fluid inside the sphere, which
# takes rho V dU/dt of it; the load does not contain this. A lag of the fluid behind the sphere counts as an error.
set -euo pipefail
mean=$([ "$1" = forcing ] || grep -q 'load: reaction' scene.resolved.yaml && echo 0.5 || echo 0)
awk -F, -v by="$1" -v what="$2" -v nu="$3" -v mean="$mean" 'BEGIN { pi = atan2(0, -1); w = 2 * pi; U = 1e-3 }
  $1 == "step" { for (i = 1; i <= NF; i++) at[$i] = i; next }
  !/^[0-9]/ { next }
  { n++; dt = $at["dt"]; f[n] = by == "forcing" ? -$at["forcing_x"] : $at["load_x"]
    t[n] = $2 - mean * dt; end = $2; gap = $2 - before; before = $2 }
  END {
    samples = int(1 / gap + 0.5)
    for (i = n - samples + 1; i <= n; i++) { s += f[i] * sin(w * t[i]); c += f[i] * cos(w * t[i]) }
    s *= 2 / samples; c *= 2 / samples
    # the forcing also moves the fluid inside: the force on the sphere is F = -forcing + rho V dU/dt
    if (by == "forcing") c += 4 * pi / 3 * U * w
    printf "%.10g\n", -(what == "velocity" ? s : c) / (6 * pi * nu * U) }' series.csv
