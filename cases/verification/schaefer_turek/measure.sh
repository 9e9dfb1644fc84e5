#!/usr/bin/env bash
# Prints a number of the run in this folder. usage: measure.sh WHAT MEAN_VELOCITY [AFTER]
#   cd_forcing, cl_forcing, cd_probe, cl_probe  2 F/(rho U^2 D b), the last value
#   dp          pressure in front minus pressure behind, each extrapolated to the surface by a parabola through the
#               values two, three and four cells away
#   dp_surface  the same, read on the surface, where the forcing smooths the pressure
#   la          length of the eddies, from the last change of sign of u on the axis
# Over whole periods of the lift after AFTER:
#   cd_max, cl_max  means of the periods' largest values
#   strouhal        Strouhal number
#   dp_half         dp half a period after the largest lift
# Diameter 0.1, density 1.
set -euo pipefail
what=$1 mean=$2 after=${3:-0}
span=$(awk -F'[][,]' '/^ *size:/ { print $4; exit }' scene.resolved.yaml)
awk -F, -v what="$what" -v q="$(awk "BEGIN { print 0.05 * $mean * $mean * $span }")" -v mean="$mean" -v after="$after" \
  -v OFMT=%.10g '
  function off() {
    return what == "dp_surface" ? p[0] - p[1] : 6 * p[2] - 8 * p[3] + 3 * p[4] - (6 * p[5] - 8 * p[6] + 3 * p[7]) }
  FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  !/^[0-9]/ { next }
  NR == FNR && $3 < 8 { p[$3] = $10; if ($3 == 7) dp[$1] = off(); next }
  NR == FNR { if ($7 >= 0 && u < 0) eddy = x + ($4 - x) * u / (u - $7); u = $7; x = $4; next }
  { n++; step[n] = $1; t[n] = $2
    cd[n] = -$at["forcing_x"] / q; cl[n] = -$at["forcing_y"] / q
    cd_probe = $at["load_x"] / q; cl_probe = $at["load_y"] / q
    if ($2 >= after) { sum += cl[n]; samples++ } }
  END {
    if (what == "cd_forcing") { print cd[n]; exit }
    if (what == "cl_forcing") { print cl[n]; exit }
    if (what == "cd_probe") { print cd_probe; exit }
    if (what == "cl_probe") { print cl_probe; exit }
    if (what == "la") { print eddy - 0.25; exit }
    if (what == "dp" || what == "dp_surface") { print off(); exit }
    level = sum / samples # where the lift rises through its mean a period begins
    for (i = 2; i <= n; i++) {
      if (t[i] >= after && cl[i-1] < level && cl[i] >= level) {
        up = t[i-1] + (t[i] - t[i-1]) * (level - cl[i-1]) / (cl[i] - cl[i-1])
        if (begun) { periods++; cd_sum += cd_most; cl_sum += cl_most; top[periods] = top_at } else first = up
        begun = 1; last = up; cd_most = cl_most = -1e30 }
      if (cd[i] > cd_most) cd_most = cd[i]
      if (cl[i] > cl_most) { cl_most = cl[i]; top_at = i } }
    if (periods < 3) exit 1
    period = (last - first) / periods
    if (what == "cd_max") print cd_sum / periods
    if (what == "cl_max") print cl_sum / periods
    if (what == "strouhal") print 0.1 / (period * mean)
    if (what == "dp_half") {
      for (k = 1; k <= periods; k++) { i = top[k]; while (t[i] < t[top[k]] + period / 2) i++; all += dp[step[i]] }
      print all / periods } }' fluid_probes.csv series.csv
