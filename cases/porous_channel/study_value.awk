# A number from the series.csv of a short run. Time begins when the block is released, after the last row with a rigid
# solid. usage: awk -v what=WHAT -f study_value.awk series.csv
#   first  time of the first broken bond, s
#   onset  time at which 0.1 % of the bonds are broken, s, interpolated between two rows
#   share  share of broken bonds at the end
BEGIN { FS = ","; let_go = 0.0384030 }
NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
NR == 2 || $c["t"] < let_go { next }
{
  t = $c["t"] - let_go; broken = $c["bonds_broken"]; share = broken / (broken + $c["bonds_intact"])
  if (broken > 0 && first == "") first = t
  if (share > 1e-3 && onset == "") onset = t_last + (t - t_last) * (1e-3 - share_last) / (share - share_last)
  t_last = t; share_last = share
}
END { print what == "first" ? first : what == "onset" ? onset : share }
