# Prints one number of an impact of two bodies. usage: awk -F, -v what=... -f measure.awk RUN/bodies.csv RUN/series.csv
#   duration   from the first to the last sample with more than 0.1 % of the largest contact force
#   force      the largest contact force's size, mean of five samples
#   mean       the impulse over the duration
#   left       velocity of the first body at the end over that at the start, along the latter
#   gained     velocity of the second body at the end over that of the first at the start, along the latter
#   restitution  the second's velocity relative to the first at the end, over the first's at the start
#   across     largest component of the contact force across the first body's velocity, over the largest force
#   energy     kinetic + strain + contact energy at the end over the kinetic energy at the start, less 1
#   worst      the largest size of the same during the impact
#   held       the largest share of the energy that contact holds
#   momentum   size of the change of the momentum over that at the start
function size(x) { return x < 0 ? -x : x }
FNR == 1 { delete at; for (i = 1; i <= NF; i++) at[$i] = i; file++; dim = "momentum_z" in at ? 3 : 2; next }
FNR == 2 { next }
file == 1 {
  b = $at["body"]; m = $at["mass"]
  p[1] = $at["momentum_x"]; p[2] = $at["momentum_y"]; p[3] = dim == 3 ? $at["momentum_z"] : 0
  f[1] = $at["contact_x"]; f[2] = $at["contact_y"]; f[3] = dim == 3 ? $at["contact_z"] : 0
  if ($1 == 0) start += $at["e_kinetic"]
  if ($1 == 0 && b == 0) {
    for (i = 1; i <= 3; i++) v += (p[i] / m) ^ 2
    v = sqrt(v)
    for (i = 1; i <= 3; i++) e[i] = p[i] / m / v
  }
  along = 0
  for (i = 1; i <= 3; i++) along += p[i] / m * e[i]
  last[b] = along / v
  if (b == 1) {
    t[++n] = $at["t"]; along = all = 0
    for (i = 1; i <= 3; i++) { along += f[i] * e[i]; all += f[i] ^ 2 }
    force[n] = along
    side = all - along ^ 2 > 0 ? sqrt(all - along ^ 2) : 0
    if (side > across) across = side
    if (along > most) most = along
  }
  next
}
{
  q = $at["e_kinetic_solid"] + $at["e_strain"] + $at["e_contact"]
  if ($at["e_contact"] > held) held = $at["e_contact"]
  if (size(q / start - 1) > worst) worst = size(q / start - 1)
  p[1] = $at["momentum_x"]; p[2] = $at["momentum_y"]; p[3] = dim == 3 ? $at["momentum_z"] : 0
  if (FNR == 3) for (i = 1; i <= 3; i++) { p0[i] = p[i]; scale += p[i] ^ 2 }
  d = 0
  for (i = 1; i <= 3; i++) d += (p[i] - p0[i]) ^ 2
  if (d > lost) lost = d
}
END {
  for (i = 1; i <= n; i++) {
    if (force[i] > 0.001 * most) { if (!first) first = i; ended = i }
    if (i > 1) impulse += (force[i] + force[i - 1]) / 2 * (t[i] - t[i - 1])
    five = 0
    for (j = i - 2; j <= i + 2; j++) five += (j in force ? force[j] : 0) / 5
    if (five > peak) peak = five
  }
  if (ended == n) { print "they have not parted" > "/dev/stderr"; exit 1 }
  duration = t[ended] - t[first]
  r["duration"] = duration; r["force"] = peak; r["mean"] = impulse / duration
  r["restitution"] = last[1] - last[0]
  r["left"] = last[0]; r["gained"] = last[1]; r["across"] = across / most
  r["energy"] = q / start - 1; r["worst"] = worst; r["held"] = held / start; r["momentum"] = sqrt(lost / scale)
  printf "%.10g\n", r[what]
}
