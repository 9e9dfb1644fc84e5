#!/usr/bin/env bash
# The effective position of two immersed planes in the flow, at ten offsets from the grid and on two grids.
# usage: cases/verification/planes/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

# expected OFFSET CELLS: the mean over both faces of R - r_d - (v + r_d^2 - E)/h, with h the width of the channel, phi
# Roma's kernel and z_i the places of the cells' centres from the markers. The markers read a profile with a kink, which
# the force spreads: R = sum_ij phi_i phi_j (z_j - z_i)_+ . It is curved on the fluid's side, v = sum_i phi_i z_i^2, and
# less so behind the face, where the driving is taken from the spread volume t of the solid: E = 2 sum_i phi_i D_i with
# D_{i-1} - 2 D_i + D_{i+1} = t_i and D = 0 on the fluid's side.
expected() {
  awk -v q="$1" -v n="$2" 'function phi(s) { s = s < 0 ? -s : s
      return s <= 0.5 ? (1 + sqrt(1 - 3 * s * s)) / 3 : s <= 1.5 ? (5 - 3 * s - sqrt(1 - 3 * (1 - s) ^ 2)) / 6 : 0 }
    function part(x,   i, z, sum) { # of the kernel below x
      for (i = 0; i < 300; i++) { z = (i - 149.5) / 100; if (z < x) sum += phi(z) / 100 }
      return sum }
    function face(place,   i, j, v, e, kink) {
      place -= int(place)
      for (i = -4; i <= 4; i++) { y[i] = i + 0.5 - place; w[i] = phi(y[i] + r); v += w[i] * (y[i] + r) ^ 2 }
      D[4] = D[3] = 0
      for (i = 3; i > -4; i--) D[i - 1] = 2 * D[i] - D[i + 1] + part(-y[i])
      for (i = -4; i <= 4; i++) {
        e += 2 * w[i] * D[i]
        for (j = i; j <= 4; j++) kink += w[i] * w[j] * (y[j] - y[i])
      }
      return kink - r - (v + r * r - e) / h }
    BEGIN { r = 0.28; h = n - 4.6; print (face(q + 0.6) + face(1 - q)) / 2 }'
}
# planes STUDY CELLS: mean and spread over the offsets, and the largest difference from the expected value
planes() {
  study "$1"
  local miss=0 o
  for o in 0 1 2 3 4 5 6 7 8 9; do
    miss=$(awk -v m="$miss" -v a="$(cell "$1" value .$o "$2" shift)" -v b="$(expected 0.$o "$2")" \
      'BEGIN { d = a - b; d = d < 0 ? -d : d; print (d > m ? d : m) }')
  done
  read -r mean spread < \
    <(awk -F, '$4 == "shift" { s += $6; if (!n++ || $6 < low) low = $6; if (n == 1 || $6 > high) high = $6 }
    END { print s / n, high - low }' "$tables/$1.csv")
  row "$2 cells: mean shift of the walls over ten offsets" cells "$mean" 0 "the planes as given" -0.05 0.05
  row "$2 cells: spread" cells "$spread" 0 "no locking to the grid" 0 0.03
  row "$2 cells: largest difference from the kernel's own shift" cells "$miss" 0 "Roma's kernel on a bent profile" 0 \
    0.003
}
planes study 64
if [ ! "$quick" ]; then
  planes study_fine 128
  study study_how
fi
finish
