#!/bin/sh
# Prints, from probes.csv, of the spheroid's half turn from lying along the flow to lying along it again:
#   period  its time over that of Jeffery's orbit, pi (r + 1/r)/gamma with r = 2
#   fast    the rate of turning across the flow over Jeffery's, gamma r^2/(r^2 + 1)
# usage: orbit.sh period|fast
shear=$(sed -n '/y_high/,/velocity/s/.*velocity: *\[\([-0-9.e]*\).*/\1/p' scene.resolved.yaml | head -n 1)
height=$(sed -n 's/^ *size: *\[[^,]*, *\([0-9.e]*\).*/\1/p' scene.resolved.yaml | head -n 1)
awk -F, -v what="$1" -v wall="$shear" -v height="$height" '
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR <= 2 { next }
  { p = $at["probe"]; x[p] = $at["x"] + $at["displacement_x"]; y[p] = $at["y"] + $at["displacement_y"] }
  p == 1 { t = $at["t"]; angle = -atan2(y[0] - y[1], x[0] - x[1]); pi = atan2(0, -1)
    while (n && angle < was - pi) angle += 2 * pi
    if (n && was < 0 && angle >= 0) from = t - (t - last) * angle / (angle - was)
    if (n && was < pi / 3 && angle >= pi / 3) third = t - (t - last) * (angle - pi / 3) / (angle - was)
    if (n && was < 2 * pi / 3 && angle >= 2 * pi / 3) two = t - (t - last) * (angle - 2 * pi / 3) / (angle - was)
    if (n && was < pi && angle >= pi) to = t - (t - last) * (angle - pi) / (angle - was)
    was = angle; last = t; n++ }
  END { if (!to) { print "no half turn" > "/dev/stderr"; exit 1 }
    shear = 2 * wall / height
    # Jeffery: tan angle = (1/r) tan(t gamma/(r + 1/r)), angle from the flow; from 60 to 120 degrees
    middle = 2 * 2.5 / shear * (pi / 2 - atan2(2 * sqrt(3), 1))
    printf "%.6g\n", what == "period" ? (to - from) * shear / (pi * 2.5) : middle / (two - third) }' probes.csv
