# Area of cracks (m2) and pressure drop (Pa) of each run of study_horizon.yaml over the time (s) since the block is
# released, every 0.4 ms, as far as the run went. VALUES gets a line for each run: pressure drop of the hold (Pa),
# intrinsic permeability before bonds break (m2), times of the first broken bond and of 0.7 cm2 of cracks (s), and the
# last time with the area and the pressure drop then.
# usage: awk -F, -v values=VALUES -f study_horizon.awk RUNS/METHOD/LEVEL/1/{intrinsic,series}.csv ...
BEGIN { let_go = 0.0384030; every = 4e-4; most = 20 }
FNR == 1 {
  delete c
  for (i = 1; i <= NF; i++) c[$i] = i
  parts = split(FILENAME, part, "/")
  run = part[parts - 3] "_" part[parts - 2]
  if (!(run in number)) { number[run] = ++runs; name[runs] = run }
  r = number[run]
  k = 1
}
FNR < 3 { next }
"k_xx" in c { if (!(r in permeability)) permeability[r] = $c["k_xx"]; next }
{
  t = $c["t"] - let_go; area = $c["crack_area"]
  if (t < 1e-9) hold[r] = $c["dp"]
  if (t > 0 && $c["bonds_broken"] > 0 && !(r in first)) first[r] = t
  if (t > 0 && area > 7e-5 && !(r in crossed))
    crossed[r] = t_last + (t - t_last) * (7e-5 - area_last) / (area - area_last)
  for (; k <= most && t >= k * every - 1e-9; k++) {
    f = (k * every - t_last) / (t - t_last)
    area_at[r, k] = sprintf("%.6g", area_last + f * (area - area_last))
    dp_at[r, k] = sprintf("%.6g", dp_last + f * ($c["dp"] - dp_last))
  }
  t_last = t; area_last = area; dp_last = $c["dp"]
  end[r] = sprintf("%.6g,%.6g,%.6g", t, area, $c["dp"])
}
END {
  head = "t"; units = "#s"
  for (r = 1; r <= runs; r++) { head = head "," name[r] "_area," name[r] "_dp"; units = units ",m2,Pa" }
  print head; print units
  for (k = 1; k <= most; k++) {
    line = k * every
    for (r = 1; r <= runs; r++) line = line "," area_at[r, k] "," dp_at[r, k]
    print line
  }
  print "run,dp_hold,k,first_bond,crossed,t_end,area_end,dp_end" >values
  print "#,Pa,m2,s,s,s,m2,Pa" >values
  for (r = 1; r <= runs; r++)
    printf "%s,%.6g,%.6g,%.6g,%.6g,%s\n", name[r], hold[r], permeability[r], first[r], crossed[r], end[r] >values
}
