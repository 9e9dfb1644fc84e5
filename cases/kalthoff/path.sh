# shellcheck shell=bash
# The numbers of a crack of this case, sourced by bash.

# path_of FILE HEIGHT: five numbers of the crack whose tips are in FILE (step, t, x, y and more, as in crack.csv), and
# whose notch ends at x = 50 mm, y = HEIGHT: the angle (degrees) of the chord from the notch's tip to the end of the
# crack; the angle of a line fitted by least squares to the positions of the tip; the time (s) at which the tip is 2 mm
# away from the notch; the top speed (m/s) over windows of 1.82 us; the same over windows of 9.1 us. All are nan if the
# crack has not left the notch.
path_of() {
  awk -F, -v y0="$2" '
    NR < 3 { next }
    { n++; t[n] = $2; x[n] = $3; y[n] = $4; if (!start && $4 > y0 + 0.002) start = $2 }
    $4 > y0 + 0.003 && ($3 != x[n - 1] || $4 != y[n - 1]) { m++; a += $3; b += $4; ab += $3 * $4; bb += $4 * $4 }
    function top(window,  i, k, v, most) {
      for (i = k = 1; i <= n; i++) {
        while (t[i] - t[k] > 1.01 * window) k++
        if (t[i] - t[k] < 0.99 * window) continue
        v = sqrt((x[i] - x[k]) ^ 2 + (y[i] - y[k]) ^ 2) / (t[i] - t[k])
        if (v > most) most = v }
      return most }
    END { d = 45 / atan2(1, 1)
      if (m < 2) { print "nan nan nan nan nan"; exit }
      printf "%.2f %.2f %.4g %.0f %.0f\n", d * atan2(y[n] - y0, x[n] - 0.05), d * atan2(bb - b * b / m, ab - a * b / m),
        start, top(1.82e-6), top(9.1e-6) }' "$1"
}
