# A number of the crack that goes on from the initial one: awk -F, -v what=WHAT -v cx=X -v cy=Y -v r=R -f path.awk FILE
#   start    the time at which its tip has moved by 1 mm, s
#   x, y     of its tip at the end, mm; gap: from there to the edge of the hole, whose centre is (X, Y) m
#   outcome  a word: drawn_in, passes (30 mm: the plate's width), stops
NR < 3 { next }
NR == 3 { x0 = $3 }
{ x = $3; y = $4; if (!start && x > x0 + 0.001) start = $2 }
END {
  gap = sqrt((x - cx) ^ 2 + (y - cy) ^ 2) - r
  if (what == "start") printf "%.4g\n", start
  if (what == "x") printf "%.4g\n", 1e3 * x
  if (what == "y") printf "%.4g\n", 1e3 * y
  if (what == "gap") printf "%.2f\n", 1e3 * gap
  if (what == "outcome") print (gap < 0.002 ? "drawn_in" : x > 0.03 - 0.003 ? "passes" : "stops")
}
