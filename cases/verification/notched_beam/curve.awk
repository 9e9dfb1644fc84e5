# Prints one number of a beam's load-opening curve. All lengths are in spacings, W = 32, S = 4 W, E = 1.
#   compliance  opening of the notch's mouth over the load, over that of a notch as deep as the first tip, less 1
#   depth       depth of the notch by the compliance of the first reading
#   peak        largest load over that of a notch of 16 at G = G0
#   onset       G/G0 at the largest load, of the depth by the compliance then
#   follows     largest distance between depth by the compliance and the tip in crack.csv, from the first reading on
#   taken       work less strain energy, over the length that the crack has run since the largest load, over G0
#   broken      the same of e_fracture
#   last        depth by the compliance at the last reading
# Strain-energy release and opening of a bent beam with S = 4 W.  (Tada, Paris and Irwin 2000)
# usage: awk -F, -v what=... -f curve.awk reactions.csv probes.csv crack.csv series.csv
function opening(a) { return 0.76 - 2.28 * a + 3.87 * a ^ 2 - 2.04 * a ^ 3 + 0.66 / (1 - a) ^ 2 }
function intensity(a) {
  return 3 * sqrt(a) * (1.99 - a * (1 - a) * (2.15 - 3.93 * a + 2.7 * a ^ 2)) / (2 * (1 + 2 * a) * (1 - a) ^ 1.5)
}
function compliance(a) { return 6 * S * a * opening(a / W) / W ^ 2 }
function depth(c,  low, high, middle, i) {
  low = 0.05 * W; high = 0.98 * W
  for (i = 0; i < 60; i++) { middle = (low + high) / 2; if (compliance(middle) < c) low = middle; else high = middle }
  return low
}
function rate(p, a) { return (p * S / W ^ 1.5 * intensity(a / W)) ^ 2 }
BEGIN { W = 32; S = 128; g0 = 1e-5 }
FNR == 1 { delete at; for (i = 1; i <= NF; i++) at[$i] = i; file++; next }
FNR == 2 || $1 == 0 { next }
file == 1 { if ($at["load"] == 0 && $at["index"] == 0) { p[$1] = -$at["force_y"]; n = $1 } }
file == 2 { x[$1, $at["probe"]] = $at["displacement_x"] }
file == 3 { tip[$1] = $at["tip_y"] }
file == 4 { rest[$1] = $at["e_constraint"] - $at["e_strain"]; fracture[$1] = $at["e_fracture"] }
END {
  for (i = 1; i <= n; i++) {
    c[i] = (x[i, 1] - x[i, 0]) / p[i]; a[i] = depth(c[i])
    if (p[i] > most) { most = p[i]; when = i }
    off = a[i] - tip[i]; if (off < 0) off = -off; if (off > far) far = off
  }
  r["depth"] = a[1]; r["compliance"] = c[1] / compliance(tip[1]) - 1
  r["peak"] = most / sqrt(g0 / rate(1, 16)); r["onset"] = rate(most, a[when]) / g0
  r["follows"] = far; r["last"] = a[n]
  r["taken"] = (rest[n] - rest[when]) / (a[n] - a[when]) / g0
  r["broken"] = (fracture[n] - fracture[when]) / (a[n] - a[when]) / g0
  printf "%.10g\n", r[what]
}
