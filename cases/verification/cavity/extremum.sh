#!/bin/sh
# Prints an extremum of a velocity on a centreline at the run's end, from a quadratic through the extreme value and its
# neighbours.
# usage: extremum.sh u_min|v_max|v_min, in the run folder
awk -F, -v what="$1" 'NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i } NR <= 2 { next }
  $k["step"] != step { step = $k["step"]; nu = nv = 0 }
  $k["x"] == 0.5 && $k["y"] != 0.5 { u[++nu] = $k["u"] }
  $k["y"] == 0.5 && $k["x"] != 0.5 { v[++nv] = $k["v"] }
  END { sign = (what == "v_max") ? 1 : -1; n = (what == "u_min") ? nu : nv; at = 2
    for (i = 1; i <= n; i++) q[i] = (what == "u_min") ? u[i] : v[i]
    for (i = 2; i < n; i++) if (sign * q[i] > sign * q[at]) at = i
    slope = (q[at + 1] - q[at - 1]) / 2; bend = q[at + 1] - 2 * q[at] + q[at - 1]
    printf "%.10g\n", q[at] - slope * slope / bend / 2 }' fluid_probes.csv
