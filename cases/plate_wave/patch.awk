# What a model does to the refined particles: awk -v run=RUN -f patch.awk UNIFORM RUN, both by over_time of draw.sh.
# Prints place, the volume within the horizon over the circle of it (000: fig. 34), and by how much the largest
# densities of strain and of kinetic energy over time fall short of the uniform grid's, % (000: tables 1, 2, fig. 35).
# A maximum over time is that of a parabola through the largest sample and its neighbours. The uniform grid's is
# interpolated along x in the row y = 0.02, as the wave is plane.
FNR == 1 { table++; i = 0; sample = 0 }
/^#/ { sample++; i = 0; next }
++i && !sample {
  if ($1 < 0.044 || $1 > 0.056 || $2 < 0.014 || $2 > 0.026) next
  n[table] = i; x[table, i] = $1; y[table, i] = $2; volume[table, i] = $3; fine[table, i] = $4
  next
}
(table, i) in x {
  for (k = 1; k <= 2; k++) {
    value = w[table, i, k, sample] = k == 1 ? $1 : $2 ^ 2
    if (!((table, i, k) in most) || value > w[table, i, k, most[table, i, k]]) most[table, i, k] = sample
  }
}
END {
  for (i = 1; i <= n[1]; i++)
    if ((1, i) in x && (y[1, i] - 0.02) ^ 2 < 1e-10)
      for (k = 1; k <= 2; k++) peak[k, int(x[1, i] / 5e-4 + 0.5)] = top(1, i, k)
  for (i = 1; i <= n[2]; i++) if ((2, i) in x) at[place(x[2, i]), place(y[2, i])] = i
  for (i = 1; i <= n[2]; i++)
    if (fine[2, i]) printf "%s,%.6g,%.6g,%.5g,%.4g,%.4g\n", run, x[2, i], y[2, i], within(i), loss(i, 1), loss(i, 2)
}
function top(t, i, k,  s, a, b, c) {
  s = most[t, i, k]; a = w[t, i, k, s - 1]; b = w[t, i, k, s]; c = w[t, i, k, s + 1]
  return a && c && 2 * b > a + c ? b + (a - c) ^ 2 / (8 * (2 * b - a - c)) : b
}
function loss(i, k,  site, low) {
  site = x[2, i] / 5e-4; low = int(site + 1e-6)
  return 100 * (1 - top(2, i, k) / (peak[k, low] + (site - low) * (peak[k, low + 1] - peak[k, low])))
}
function place(c) { return int(c / 2.5e-4 + 0.5) }
# The volumes within the horizon with the ramp's weights (000: eq. 22) over pi delta^2
function within(i,  delta, k, l, j, size, far, part, sum, p, q) {
  p = place(x[2, i]); q = place(y[2, i]); delta = run ~ /^a$|kept/ ? 1.5e-3 : 7.5e-4
  for (k = -1; k <= 1 && run == "b_corrected"; k++)
    for (l = -1; l <= 1; l++) if (((p + k, q + l) in at) && !fine[2, at[p + k, q + l]]) delta = sqrt(2) * 7.5e-4
  for (k = -7; k <= 7; k++)
    for (l = -7; l <= 7; l++) {
      far = sqrt(k * k + l * l) * 2.5e-4
      if (!((p + k, q + l) in at) || far > delta * (1 + 1e-9)) continue
      j = at[p + k, q + l]; size = fine[2, j] ? 2.5e-4 : 5e-4
      part = (delta + size / 2 - far) / size
      sum += volume[2, j] * (part > 1 ? 1 : part)
    }
  return sum / (atan2(0, -1) * delta ^ 2)
}
