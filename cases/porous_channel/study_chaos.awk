# How far runs drift apart whose inflow differs by a factor of 1 + 1e-12 to 1 + 1e-4. Prints one row a sample, from the
# moment at which bonds may break.
# usage: awk -f study_chaos.awk RUN/0/series.csv RUN/1e-12/series.csv ...    the others are compared with the first
BEGIN { FS = "," }
FNR == 1 {
  parts = split(FILENAME, part, "/"); name[++member] = part[parts - 1]
  for (i = 1; i <= NF; i++) c[$i] = i; next
}
FNR == 2 { row = 0; next }
{
  if (!row++) begin = $c["t"] - $c["dt"]
  t[row] = $c["t"] - begin; dp[member, row] = $c["dp"]; broken[member, row] = $c["bonds_broken"]
  if (row > rows) rows = row
}
END {
  printf "t,dp,bonds_broken"
  for (m = 2; m <= member; m++) printf ",dp_%s_off,bonds_%s_off", name[m], name[m]
  print ""
  for (r = 1; r <= rows; r++) {
    printf "%.6g,%.8g,%d", t[r], dp[1, r], broken[1, r]
    for (m = 2; m <= member; m++) printf ",%.3g,%d", dp[m, r] / dp[1, r] - 1, broken[m, r] - broken[1, r]
    printf "\n"
  }
}
