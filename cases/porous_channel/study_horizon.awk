# Of each run of study_horizon.yaml: k, the pressure drop of the hold, when the first bond breaks and 0.7 cm2 of cracks
# are there (time since the release), and every 0.4 ms the area of cracks (m2) and the pressure drop (Pa).
# usage: awk -F, -f study_horizon.awk RUNS/METHOD/LEVEL/1/{intrinsic,series}.csv ...
BEGIN { print "run,quantity,value" }
function say(what, value) { printf "%s,%s,%.6g\n", run, what, value }
FNR == 1 {
  for (i = 1; i <= NF; i++) c[$i] = i
  n = split(FILENAME, part, "/"); run = part[n - 3] " " part[n - 2]; broke = crossed = 0; k = 1
}
FNR < 3 || FILENAME ~ /intrinsic/ { if (FNR == 3) say("k (m2)", $c["k_xx"]); next }
{
  t = $c["t"] - 0.0384030; area = $c["crack_area"]; dp = $c["dp"]
  if (t * t < 1e-12) say("dp of the hold", dp)
  if ($c["bonds_broken"] > 0 && !broke++) say("first bond (s)", t)
  if (area > 7e-5 && !crossed++) say("0.7 cm2 of cracks (s)", last + (t - last) * (7e-5 - was) / (area - was))
  if (t >= k * 4e-4 - 1e-9) {
    f = (k * 4e-4 - last) / (t - last)
    say("area at " k * 4e-4 " s", was + f * (area - was)); say("dp at " k++ * 4e-4 " s", dp_was + f * (dp - dp_was))
  }
  last = t; was = area; dp_was = dp
}
