#!/usr/bin/env bash
# Prints a measure of the fall. usage: fall.sh speed|time
#   speed  the largest speed over u_inf while the sphere is at least two diameters above the floor
#   time   the time at which the gap below is four diameters, half of the way, s
# u_inf is from Abraham's formula for the drag (1970), as in ten Cate et al. (2002) for each of their four liquids.
set -euo pipefail
density=$(awk '/^fluid:/ { on = 1 } on && /density:/ { print $2; exit }' scene.resolved.yaml)
awk -F, -v what="$1" -v density="$density" -v OFMT=%.8g 'BEGIN { u[970] = 0.03829; u[965] = 0.05992; u[962] = 0.09062;
  u[960] = 0.12839 }
  FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  !/^[0-9]/ { next }
  { t = $2; down = -$at["displacement_y"]; if (down > 0.09) exit
    v = -$at["velocity_y"]; if (v > most) most = v
    if (down > 0.06 && !when) when = before + (t - before) * (0.06 - last) / (down - last)
    before = t; last = down }
  END { if (what == "speed") print most / u[density + 0]; else print when }' probes.csv
