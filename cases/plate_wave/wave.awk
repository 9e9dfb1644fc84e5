# What a wave does at a refined patch, from tables of runs (probes.csv, series.csv), that of the uniform run first.
# usage: awk -F, -v what=WHAT -f wave.awk [UNIFORM] TABLE
#     reflection    largest |u - u uniform| in front of the patch after the pulse has passed, over the pulse's height, %
#     energy        largest difference between the total energy and that of the uniform run, %; what is lost is positive
#     affine        under an affine displacement, in or near the patch: largest change of the energy density, %
#     force         there, largest force density times delta/(E strain), which should be 0 (one table)
#     top           time at which the pulse's top passes x = 0.04, from a parabola through the highest sample and its
#                   neighbours (one table)
#     speed         error of the wave's speed, %: the mean times, weighted by the squared displacement, at which it
#                   passes the nine places are fitted by a line; the continuum's speed is sqrt(E/((1 - nu^2) rho)), nu =
#                   1/3 (one table)
function size(x) { return x < 0 ? -x : x }
FNR == 1 { table++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
FNR <= 2 { next }
{ t = $k["t"]; p = $k["probe"]; u = $k["displacement_x"]; w = $k["energy_density"]; is_uniform = table == 1 }
what == "reflection" && p == 0 {
  if (is_uniform) { uniform[t] = u; if (u > top) top = u }
  else if (t >= 0.05 && (d = size(u - uniform[t])) > most) most = d
}
what == "energy" {
  e = $k["e_kinetic_solid"] + $k["e_strain"]
  if (is_uniform) uniform[t] = e
  else { d = 1 - e / uniform[t]; if (d * d > most * most) most = d }
}
what == "affine" && t == 0 && p >= 2 {
  if (is_uniform) uniform[p] = w
  else { d = 1 - w / uniform[p]; if (d * d > most * most) most = d }
}
what == "force" && t > 0 && p >= 2 && (a = size($k["velocity_x"] / t)) > most { most = a }
what == "top" && p == 1 { n++; at_t[n] = t; at_u[n] = u; if (u > at_u[at]) at = n }
what == "speed" { x[p] = $k["x"]; weight[p] += u ^ 2; mean[p] += u ^ 2 * t }
END {
  if (what == "reflection") print 100 * most / top
  else if (what == "energy" || what == "affine") print 100 * most
  else if (what == "force") print most * 0.0015 / 1e-8
  else if (what == "top") {
    before = at_u[at - 1]; after = at_u[at + 1]
    print at_t[at] + 0.5 * (at_t[2] - at_t[1]) * (before - after) / (before - 2 * at_u[at] + after)
  } else {
    for (p in x) { n++; mean[p] /= weight[p]; a += x[p]; b += mean[p] }
    for (p in x) { xt += (x[p] - a / n) * (mean[p] - b / n); tt += (mean[p] - b / n) ^ 2 }
    print 100 * (xt / tt / sqrt(9 / 8) - 1)
  }
}
