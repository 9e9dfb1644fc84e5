#!/usr/bin/env bash
# Prints, in a run folder, the pressure over its value in elastic theory when the first bond breaks (over Griffith's
# p_c), or when the tip has moved by three spacings. The pressure acts only on the initial crack's faces, |x| < a:
#     K = 2 p sqrt((a + s)/pi) asin(a/(a + s)):   p(s) = p_c (pi/2) sqrt(a/(a + s))/asin(a/(a + s))
# usage: initiation.sh first|runs
set -euo pipefail
read -r a ramp < \
  <(awk -F'[][,]' '/^  cracks:/ { in_crack = 1 } in_crack && /- \[/ { x[++n] = $2 } n == 2 { in_crack = 0 }
  /name: ramp/ { in_ramp = 1 } in_ramp && /steps:/ { sub(/.*: /, ""); ramp = $0; in_ramp = 0 } END {
    print (x[2] - x[1]) / 2, ramp }' scene.resolved.yaml)
if [ "$1" = first ]; then
  awk -F, -v ramp="$ramp" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 { n = $at["bonds_broken"]; if (start == "") start = n; if (n > start) { print 0.5 + 1.5 * $at["t"] / ramp;
      exit } }' series.csv
else
  awk -F, -v ramp="$ramp" -v a="$a" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 { x = $at["tip_x"]; if (start == "") start = x
      if (x > start + 2.9) {
        s = x - start; r = a / (a + s); pi = atan2(0, -1)
        print (0.5 + 1.5 * $at["t"] / ramp) * 2 / pi * atan2(r, sqrt(1 - r * r)) / sqrt(r)
        exit
      } }' crack.csv
fi
