#!/bin/sh
# Prints the velocity along the channel at a probe and a time. error: the largest difference from the series solution at
# both probes and at the times 0.05, 0.1, 0.2, 0.5, 1, 2, over the final velocity on the axis:
#     u = 1 - y^2 - 32/pi^3 sum (-1)^n/(2n+1)^3 cos((2n+1) pi y/2) exp(-(2n+1)^2 pi^2 t/4)
# usage: velocity.sh PROBE TIME | velocity.sh error, in the run folder
awk -F, -v probe="$1" -v time="$2" 'NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i; pi = atan2(0, -1) } NR <= 2 { next }
  { t = $k["t"]; p = $k["probe"]; u = $k["u"]; now = int(t * 1000 + 0.5) }
  probe != "error" && p == probe && now == int(time * 1000 + 0.5) { printf "%.14g\n", u; found = 1; exit }
  probe == "error" && (now == 50 || now == 100 || now == 200 || now == 500 || now == 1000 || now == 2000) {
    y = $k["y"] - 1; x = 1 - y * y
    for (n = 0; n < 60; n++) { m = (2 * n + 1) * pi / 2;
      x -= 4 / (m * m * m) * (1 - 2 * (n % 2)) * cos(m * y) * exp(-m * m * t) }
    d = u - x; if (d < 0) d = -d; if (d > worst) worst = d; seen++ }
  END { if (probe == "error" && seen == 12) { printf "%.14g\n", worst; found = 1 } exit !found }' fluid_probes.csv
