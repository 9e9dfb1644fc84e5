#!/usr/bin/env bash
# Stokes' two numbers in a box with slip walls, to the first reflection: the force in phase with the velocity, and the
# force in phase with the acceleration.
# usage: box.sh RADIUS_OVER_DELTA BOX_OVER_RADIUS
#     F = -6 pi mu a ((1 + l + l^2/9)(U - u) - (2/9) l^2 u),  l = (1 + i) a/delta
# (Stokes 1851; Landau and Lifshitz). The images' dipoles make the velocity u:
#     u = S m/L^3,  m = (a^3/2)(1 + 3/l + 3/l^2)(U - u),  S = -9.6874430
# S is the sum of (3 x^2 - r^2)/r^5 over a cubic lattice, with alternating signs along x.
set -euo pipefail
awk -v k="$1" -v box="$2" 'BEGIN {
  s = -9.687443038820428 / 2 / box ^ 3
  qr = s * (1 + 1.5 / k); qi = -s * (1.5 / k + 1.5 / k ^ 2)       # q = s (1 + 3/l + 3/l^2)
  nr = 1 + k; ni = k + 2 * k * k / 9                              # (1 + l + l^2/9) - (2/9) l^2 q, l^2 = 2 i k^2
  nr += 4 * k * k / 9 * qi; ni -= 4 * k * k / 9 * qr
  d = (1 + qr) ^ 2 + qi ^ 2
  printf "%.7f %.7f\n", (nr * (1 + qr) + ni * qi) / d, (ni * (1 + qr) - nr * qi) / d }'
