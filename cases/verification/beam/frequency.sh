#!/usr/bin/env bash
# Prints, in a run folder, the first frequency over that of Timoshenko's cantilever. The frequency is that of a sine
# fitted to the tip's deflection by least squares.
# usage: frequency.sh [E G]
set -euo pipefail
# Clamped over the first three layers, or at the middle of a layer that all is symmetric about.
read -r length height < <(awk -F'[][,]' '
  /^  size:/ { size = $2; height = $3 }
  /^  constraints:/ { in_held = 1 }
  in_held && /low:/ { low = $2; in_held = 0 }
  END { print (low > 0 ? size / 2 : size - 3), height }' scene.resolved.yaml)
exact=$(awk -v l="$length" -v h="$height" -v e="${1:-1}" -v g="${2:-0.4}" -f "$(dirname "$0")/timoshenko.awk")
awk -F, -v exact="$exact" '
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 3 { n++; t[n] = $2; w[n] = $at["displacement_z"] * 1e6 }
  function explained(f,   i, c, s, cc, cs, ss, wc, ws, det) { # part of the sum of squares that a cosine and a sine fit
    for (i = 1; i <= n; i++) {
      c = cos(f * t[i]); s = sin(f * t[i])
      cc += c * c; cs += c * s; ss += s * s; wc += w[i] * c; ws += w[i] * s
    }
    det = cc * ss - cs * cs
    return (wc * (ss * wc - cs * ws) + ws * (cc * ws - cs * wc)) / det
  }
  END {
    # the largest of 120 first: the side lobes are 7 % apart after 15 periods
    for (k = 0; k <= 120; k++) { f = (0.7 + 0.005 * k) * exact; if ((q = explained(f)) > most) { most = q; best = f } }
    a = best - 0.005 * exact; b = best + 0.005 * exact; r = (sqrt(5) - 1) / 2
    for (k = 0; k < 60; k++) { p = b - r * (b - a); q = a + r * (b - a); if (explained(p) > explained(q)) b = q;
      else a = p }
    printf "%.8g\n", (a + b) / 2 / exact
  }' probes.csv
