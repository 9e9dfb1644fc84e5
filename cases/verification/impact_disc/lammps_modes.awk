# modes.csv of scene.yaml's rings from a dump of in.disc: columns id x y z damage; the first frame has the places.
BEGIN {
  rings = split("0.005 0.01 0.015 0.02 0.025 0.03 0.038", radius, " ") - 1
  print "step,t,ring,inner,outer,particles,mode,amplitude,angle"
  print "#1,s,1,m,m,1,1,1,degrees"
}
/^ITEM: TIMESTEP/ { if (on && step <= 600) write(); getline; step = $1; on = 0; delete sum; next }
/^ITEM: ATOMS/ { on = 1; next }
/^ITEM/ { on = 0 }
!on || step > 600 { next }
step == 0 {
  r = sqrt($2 * $2 + $4 * $4); theta[$1] = atan2($2, $4)
  for (q = 1; q <= rings; q++) if (r >= radius[q] && r < radius[q + 1]) ring[$1] = q
}
$1 in ring {
  q = ring[$1]
  sum[q, "n"]++; sum[q, "f"] += $5
  for (k = 1; k <= 12; k++) {
    c = cos(k * theta[$1]); s = sin(k * theta[$1])
    sum[q, k, "c"] += $5 * c; sum[q, k, "s"] += $5 * s
    sum[q, k, "c0"] += c; sum[q, k, "s0"] += s
  }
}
END { if (on && step <= 600) write() }
function write(  q, k, n, f, a, b) {
  if (step == 0) return
  for (q = 1; q <= rings; q++) {
    n = sum[q, "n"]; f = sum[q, "f"] / n
    for (k = 0; k <= 12; k++) {
      a = 2 * (sum[q, k, "c"] - f * sum[q, k, "c0"]) / n; b = 2 * (sum[q, k, "s"] - f * sum[q, k, "s0"]) / n
      printf "%d,%.6g,%d,%s,%s,%d,%d,%.6g,%.4f\n", step, step * 1e-7, q - 1, radius[q], radius[q + 1], n, k,
        k ? sqrt(a * a + b * b) : f, k ? atan2(b, a) / k * 45 / atan2(1, 1) : 0
    }
  }
}
