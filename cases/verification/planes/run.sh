#!/usr/bin/env bash
# The effective position of two immersed planes in the flow, at ten offsets from the grid and on two grids.
# usage: cases/verification/planes/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

# expected OFFSET CELLS: the mean over both faces of (1/2 + 2 phi(s - 1) phi(s + 1))/2 - r_d + 0.03/h. s is the distance
# of the marker from the nearest cell centre, h the width of the channel, phi is Roma's kernel. 0.03 is the mean over
# places of the part of the curvature in docs/retraction.md.
expected() {
  awk -v q="$1" -v n="$2" 'function phi(s) { s = s < 0 ? -s : s
      return s <= 0.5 ? (1 + sqrt(1 - 3 * s * s)) / 3 : s <= 1.5 ? (5 - 3 * s - sqrt(1 - 3 * (1 - s) ^ 2)) / 6 : 0 }
    function front(s) { s -= int(s) + 0.5; return (0.5 + 2 * phi(s - 1) * phi(s + 1)) / 2 }
    BEGIN { r = 0.28; print (front(q + r) + front(q + 0.6 - r)) / 2 - r + 0.03 / (n - 4.6) }'
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
