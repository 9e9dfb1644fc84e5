# Prints how far a tip of the bonds' crack was at most from the element-free path at the same x, mm, outside of the
# hole and a margin about it (m). usage: awk -F, -v margin=M -f off.awk hole/growth.csv RUN/crack.csv
FNR == 1 { delete k; for (i = 1; i <= NF; i++) k[$i] = i }
FNR <= 2 { next }
FNR == NR { x[++n] = $k["x"]; y[n] = $k["y"]; next }
{
  X = $k["tip_x"]; Y = $k["tip_y"]
  if (X < x[1] || sqrt((X - 0.02)^2 + (Y - 0.008)^2) < 0.004 + margin) next
  least = 1
  for (i = 1; i < n; i++) {
    dx = x[i + 1] - x[i]; dy = y[i + 1] - y[i]; f = ((X - x[i]) * dx + (Y - y[i]) * dy) / (dx * dx + dy * dy)
    f = f < 0 ? 0 : f > 1 ? 1 : f; d = sqrt((x[i] + f * dx - X)^2 + (y[i] + f * dy - Y)^2)
    if (d < least) least = d
  }
  if (least > most) most = least
}
END { printf "%.4g\n", 1e3 * most }
