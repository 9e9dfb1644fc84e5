# A number of the last complete list of fragments.csv: awk -F, -v what=WHAT -v up=COLUMN -f pieces.awk fragments.csv
#   pieces    their number
#   largest   mass of the largest one over that of the body
#   dust      share of the mass in pieces of ten particles or fewer
#   back      share of the mass in pieces that fly against the sphere, at more than 10 m/s by the velocity in COLUMN
NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
NR <= 2 { next }
$k["fragment"] == 0 { pieces = mass = largest = dust = back = 0 }
{
  m = $k["mass"]; pieces++; mass += m
  if (m > largest) largest = m
  if ($k["particles"] <= 10) dust += m
  if ($k[up] > 10) back += m
}
END {
  if (what == "pieces") print pieces
  if (what == "largest") printf "%.6g\n", largest / mass
  if (what == "dust") printf "%.6g\n", dust / mass
  if (what == "back") printf "%.6g\n", back / mass
}
