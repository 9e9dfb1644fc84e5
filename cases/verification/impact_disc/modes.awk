# A number of modes.csv at the last step, or at step S: awk -F, -v what=WHAT -v of=N [-v step=S] -f modes.awk modes.csv
#   fold       share of the modes N, 2 N, ... in the sum of the squares of all amplitudes, over all rings
#   amplitude  of mode N: root of the mean of the squares over the rings
#   angle      of mode N, degrees, by its largest amplitude of all rings
#   mean       damage, mean over the particles of all rings
NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
NR <= 2 { next }
step != "" && $k["step"] != step { next }
step == "" && $k["step"] != last { last = $k["step"]; all = some = one = rings = most = damage = particles = 0 }
{
  mode = $k["mode"]; a = $k["amplitude"]
  if (mode == 0) { rings++; damage += a * $k["particles"]; particles += $k["particles"]; next }
  all += a * a
  if (mode % of == 0) some += a * a
  if (mode == of) { one += a * a; if (a >= most) { most = a; angle = $k["angle"] } }
}
END {
  if (what == "fold") printf "%.6g\n", some / all
  if (what == "amplitude") printf "%.6g\n", sqrt(one / rings)
  if (what == "angle") printf "%.6g\n", angle
  if (what == "mean") printf "%.6g\n", damage / particles
}
