# The bands of an ensemble from the moment at which bonds may break: of each group of runs, for every 12th step, the
# least value, the median and the largest of the pressure drop over p0, of the share of bonds broken in %, of porosity,
# permeability and pieces. Runs that have not ended are left out. END gets the same of the last step, a quantity a line.
# usage: awk -F, -v end=END -f ensemble.awk RUNS/GROUP/all/MEMBER/series.csv ...
BEGIN {
  release = 388; last = 628; every = 12; quantities = 5
  all = split("dp broken porosity permeability fragments bonds_broken largest_fragment", name, " ")
}
FNR == 1 { for (i = 1; i <= NF; i++) k[$i] = i; parts = split(FILENAME, part, "/"); group = part[parts - 3] }
FNR > 2 && $k["step"] >= release && ($k["step"] - release) % every == 0 {
  s = $k["step"]; t[s] = $k["t"]; row[s, 1] = $k["dp"] / 10
  row[s, 2] = 100 * $k["bonds_broken"] / ($k["bonds_broken"] + $k["bonds_intact"])
  for (q = 3; q <= all; q++) row[s, q] = $k[name[q]]
  if (s == last) {
    m = ++members[group]
    for (i = release; i <= last; i += every) for (q = 1; q <= all; q++) x[group, i, q, m] = row[i, q]
  }
}
function band(g, s, q, digits,  n, i, j, v, y, one) {
  n = members[g]
  for (i = 1; i <= n; i++) {
    v = x[g, s, q, i]
    for (j = i; j > 1 && y[j - 1] > v; j--) y[j] = y[j - 1]
    y[j] = v
  }
  one = ",%." digits "g"
  return sprintf(one one one, y[1], (y[int((n + 1) / 2)] + y[int(n / 2) + 1]) / 2, y[n])
}
END {
  printf "run,members,t"
  for (q = 1; q <= quantities; q++) printf ",%s_least,%s,%s_most", name[q], name[q], name[q]
  printf "\n#,1,s,1,1,1,%%,%%,%%,1,1,1,m2,m2,m2,1,1,1\n"
  for (g in members)
    for (s = release; s <= last; s += every) {
      printf "%s,%d,%.6g", g, members[g], t[s] - t[release]
      for (q = 1; q <= quantities; q++) printf "%s", band(g, s, q, 6) (q < quantities ? "" : "\n")
    }
  print "run,quantity,members,least,median,most" >end
  for (g in members) for (q = 1; q <= all; q++) print g "," name[q] "," members[g] band(g, last, q, 10) >end
}
