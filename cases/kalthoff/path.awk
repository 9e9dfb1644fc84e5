# Numbers of the crack whose tips are in a table (step, t, x, y and more, as in crack.csv), and whose notch ends at
# x = 50 mm, y = y0: angle (degrees) of the chord from the notch's tip to the end of the crack; angle of a line fitted
# by least squares to the positions of the tip; time (s) at which the tip is 2 mm away from the notch; top speed (m/s)
# over windows of 1.82 us; over windows of 9.1 us. All are nan if the crack has not left the notch.
# usage: awk -F, -v y0=HEIGHT [-v n=1..5] -f path.awk crack.csv      all five, or the n-th
NR < 3 { next }
{ rows++; t[rows] = $2; x[rows] = $3; y[rows] = $4; if (!start && $4 > y0 + 0.002) start = $2 }
$4 > y0 + 0.003 && ($3 != x[rows - 1] || $4 != y[rows - 1]) { m++; a += $3; b += $4; ab += $3 * $4; bb += $4 * $4 }
function top(window,  i, k, v, most) {
  for (i = k = 1; i <= rows; i++) {
    while (t[i] - t[k] > 1.01 * window) k++
    if (t[i] - t[k] < 0.99 * window) continue
    v = sqrt((x[i] - x[k]) ^ 2 + (y[i] - y[k]) ^ 2) / (t[i] - t[k])
    if (v > most) most = v
  }
  return most
}
END {
  d = 45 / atan2(1, 1)
  all = "nan, nan, nan, nan, nan"
  if (m > 1) all = sprintf("%.2f, %.2f, %.4g, %.0f, %.0f", d * atan2(y[rows] - y0, x[rows] - 0.05),
    d * atan2(bb - b * b / m, ab - a * b / m), start, top(1.82e-6), top(9.1e-6))
  split(all, part, ", ")
  print n ? part[n] : all
}
