# The total energy by each model over time, as a table: awk -F, -f energy.awk MODEL/series.csv ...
BEGIN {
  head = "t"; units = "#s"
  for (i = 1; i < ARGC; i++) { name = ARGV[i]; sub(/\/.*/, "", name); head = head "," name; units = units ",J" }
  print head; print units
}
FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
FNR <= 2 { next }
file == 1 { step[++n] = $k["step"]; line[$k["step"]] = $k["t"] }
{ line[$k["step"]] = line[$k["step"]] sprintf(",%.8g", $k["e_kinetic_solid"] + $k["e_strain"]) }
END { for (i = 1; i <= n; i++) print line[step[i]] }
