#!/usr/bin/env bash
# Cases of plates on coarse grids: Kalthoff's cracks leave their notches at a steep angle and are mirror images to the
# bit; a crack beside a hole turns towards the hole.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
last() { awk -F, -v c="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i } END { print $k }' "$1"; }

code 0 ranks 1 run "$source/cases/kalthoff/18ni1900.yaml" --out impact
awk -v x="$(last impact/crack.csv tip_x)" -v y="$(last impact/crack.csv tip_y)" 'BEGIN {
  angle = atan2(y - 0.124, x - 0.05) * 45 / atan2(1, 1)
  print "angle", angle
  exit !(angle > 60 && angle < 72) }' || fail "the crack of the impacted plate runs elsewhere"
if command -v h5dump >/dev/null; then
  "$source/cases/crack.sh" symmetric impact 0.1 0.002 || fail "the impacted plate is not its mirror image"
fi

code 0 ranks 1 run "$source/cases/plate_hole/b.yaml" --out hole --set stages.pull.steps=1800
awk -v x="$(last hole/crack.csv tip_x)" -v y="$(last hole/crack.csv tip_y)" 'BEGIN {
  gap = sqrt((x - 0.02) ^ 2 + (y - 0.008) ^ 2) - 0.004
  print "from the tip to the hole", gap
  exit !(gap < 0.002) }' || fail "the hole does not draw in the crack"
echo ok
