# A number from the series.csv of a short run. Time begins when the block is released, after the last row with a rigid
# solid. usage: awk -v what=WHAT -f study_value.awk [scene.resolved.yaml] series.csv
#   first    time of the first broken bond, s
#   onset    time at which 0.1 % of the bonds are broken; crossed: crack_area is 7e-5 m2, s, interpolated between rows
#   share    share of broken bonds at the end
# With the scene, whose cells give the spacing, and m = 3:
#   area     area of cracks across [100] that takes as many bonds, m2, at the end: 114 bonds a spacing squared
#   cracked  time at which this area is 7e-5 m2, 0.1 % of the bonds at 128 cells, s
BEGIN { FS = ","; let_go = 0.0384030; bonds = 114; least = what ~ /^cr/ ? 7e-5 : 1e-3 }
/^  cells: / { sub(/.*\[/, ""); spacing = 0.2 / $1 }
FILENAME ~ /yaml$/ { next }
FNR == 1 { for (i = 1; i <= NF; i++) c[$i] = i; next }
FNR == 2 || $c["t"] < let_go { next }
{
  t = $c["t"] - let_go; broken = $c["bonds_broken"]; share = broken / (broken + $c["bonds_intact"])
  area = broken * spacing ^ 2 / bonds; value = what == "cracked" ? area : what == "crossed" ? $c["crack_area"] : share
  if (broken > 0 && first == "") first = t
  if (value > least && onset == "") onset = t_last + (t - t_last) * (least - value_last) / (value - value_last)
  t_last = t; value_last = value
}
END { print what == "first" ? first : what == "share" ? share : what == "area" ? area : onset }
