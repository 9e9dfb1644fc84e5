# A number of a run, from the moment on at which the block's bonds may move or break.
# usage: awk -v what=WHAT -v from=T [-v level=SHARE] [-v to=T] -f value.awk series.csv
#   cracked  time at which this share of the bonds is broken, s after `from`, interpolated between two rows
#   share    share of broken bonds at the time `to` after `from`, interpolated
# usage: awk -v what=first -v from=T -f value.awk probes.csv
#   first    time at which a bond between a probe and the held particles below it reaches the critical stretch s0, s
# Held particles do not move, so that the probes' displacements give the stretch of these bonds. Between two rows they
# are cubics through displacements and velocities: the time is resolved better than by a substep.
BEGIN { FS = ","; s0 = 2.30940108e-4; spacing = 1.5625e-3; longest = 3 }
FNR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
FNR == 2 || $c["t"] < from - 1e-9 { next }
what == "first" { probe($c["probe"], $c["t"] - from); next }
{
  t = $c["t"] - from; broken = $c["bonds_broken"] / ($c["bonds_broken"] + $c["bonds_intact"])
  slope = (broken - last) / (t - t_last + 1e-300)
  if (what == "cracked" && broken > level && value == "") value = t_last + (level - last) / slope
  if (what == "share" && t > to - 1e-9 && value == "") value = last + slope * (to - t_last)
  t_last = t; last = broken
}
END { print value }

# the largest stretch of a probe's bonds to the held particles straight below, over s0
function stretch(p, d,  k, most, xi) {
  for (k = 1; p + k <= longest; k++) {
    xi = (p + k) * spacing
    if (d / xi > most) most = d / xi
  }
  return most / s0
}
function hermite(a, va, b, vb, h, x) {
  return a * (1 + 2 * x) * (1 - x) ^ 2 + b * x ^ 2 * (3 - 2 * x) + h * x * (1 - x) * (va * (1 - x) - vb * x)
}
function probe(p, t,  d, v, low, high, x, k) {
  d = $c["displacement_y"]; v = $c["velocity_y"]
  if (p in t0 && stretch(p, d) >= 1 && !(p in done)) {
    done[p] = 1; low = 0; high = 1
    for (k = 0; k < 40; k++) {
      x = (low + high) / 2
      if (stretch(p, hermite(d0[p], v0[p], d, v, t - t0[p], x)) >= 1) high = x; else low = x
    }
    x = t0[p] + high * (t - t0[p])
    if (value == "" || x < value) value = x
  }
  t0[p] = t; d0[p] = d; v0[p] = v
}
