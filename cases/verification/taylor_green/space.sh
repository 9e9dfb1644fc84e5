#!/bin/sh
# Prints a measure of the vortices in space, per volume at density 1. usage: space.sh WHAT, in the run folder
#   energy, dissipation  at the end
#   peak, when           the largest dissipation and its time, from a parabola through the highest sample and its
#                        neighbours
#   balance              the largest |-dE/dt - dissipation| over the largest dissipation
awk -F, -v what="$1" 'NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i } NR <= 2 { next }
  { n++; t[n] = $k["t"]; e[n] = $k["e_kinetic_fluid"]; d[n] = $k["dissipation"]; if (d[n] > d[top]) top = n }
  END { pi = atan2(0, -1); volume = 8 * pi * pi * pi
    for (i = 2; i <= n; i++) { # the trapezium rule over one interval
      gap = (e[i - 1] - e[i]) / (t[i] - t[i - 1]) - (d[i] + d[i - 1]) / 2
      if (gap < 0) gap = -gap
      if (gap > worst) worst = gap }
    if (top > 1 && top < n) {
      slope = (d[top + 1] - d[top - 1]) / 2; bend = d[top + 1] - 2 * d[top] + d[top - 1]
      peak = d[top] - slope * slope / bend / 2; when = t[top] - slope / bend * (t[top + 1] - t[top]) }
    x = what == "energy" ? e[n] / volume : what == "dissipation" ? d[n] / volume : \
      what == "balance" ? worst / d[top] : what == "peak" ? peak / volume : when
    printf "%.10g\n", x }' series.csv
