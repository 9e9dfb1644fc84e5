# Shared by growth.sh and penny.sh: reads tables, writes growth.csv, and prints one number of a crack's growth.
# Variable: what, as in the usage of the scripts. They fill `single`, numbers by name, and call in each sample
#   record   with the crack's size, its opening, the well's pressure, and the reference of each ("": none);
#   sample   with one of them that counts in means, and in exponents if `late`.
BEGIN { pi = atan2(0, -1) }
FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
FNR <= 2 { next }
function abs(x) { return x < 0 ? -x : x }
function power(x, e) { return exp(e * log(x)) }
# The opening in the middle by the probes above and below the crack.
function opening(t) { return u[t, 0] - u[t, 1] }
function residual_over(residual, volume) {
  if (abs(residual / volume) > single["residual"]) single["residual"] = abs(residual / volume)
}
function record(t, volume, size, size1, w, w1, p, p1) {
  printf "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%s\n", t, volume, size, size1, w, w1, p,
    p1 == "" ? "" : sprintf("%.6g", p1) >"growth.csv"
}
function sample(name, ours, exact, time, late,  x, y) {
  n[name]++; off[name] += abs(ours / exact - 1); ratio[name] += ours / exact
  if (!late) return
  x = log(time); y = log(ours); m[name]++; sx[name] += x; sy[name] += y; sxx[name] += x * x; sxy[name] += x * y
}
function answer(  name) {
  name = what; sub(/_.*/, "", name)
  if (what in single) print single[what]
  else if (!n[name]) fail("the crack has not grown")
  else if (what ~ /_ratio$/) print ratio[name] / n[name]
  else if (what !~ /_exponent$/) print off[name] / n[name]
  else if (m[name] < 10) fail("the crack has not grown enough for an exponent")
  else print (m[name] * sxy[name] - sx[name] * sy[name]) / (m[name] * sxx[name] - sx[name]^2)
}
function fail(why) { print why >"/dev/stderr"; failed = 1; exit 1 }
