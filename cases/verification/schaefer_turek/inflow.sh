#!/usr/bin/env bash
# Prints the inflow of 3D-1Z on N x N faces: 16 U_m y z (H - y)(H - z)/H^4, U_m = 0.45 m/s, scaled to a mean over the
# faces of U_m (2/3)^2.
# usage: inflow.sh N
awk -v n="$1" 'BEGIN {
  for (i = 0; i < n; i++) { y = (i + 0.5) / n; p[i] = y * (1 - y); sum += p[i] }
  for (j = 0; j < n; j++) for (k = 0; k < n; k++) printf "%.12g\n", 0.2 * p[j] * p[k] * n * n / (sum * sum) }'
