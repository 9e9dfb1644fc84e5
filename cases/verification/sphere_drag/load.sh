#!/usr/bin/env bash
# Prints a number of the run in this folder. G is the driving gradient, which acts on the fluid and on the body; the box
# has a volume of 1 m3.
#   load     force on the body, over G
#   forcing  the forcing's force, over G
#   sum      load and forcing, over G: 0 if the load is what the forcing took from the fluid
#   drag     G over the force on a sphere of the array, 6 pi mu a U K, with mu = 1, U = 1e-3 and K of Zick and Homsy
#   felt     the same of the load on the body in place of G
# usage: load.sh load|forcing|sum|drag|felt
radius=$(sed -n 's/^ *radius: *\([^ ,}]*\).*/\1/p' scene.resolved.yaml | head -1)
awk -F, -v way="$1" -v a="$radius" '
  !at { for (i = 1; i <= NF; i++) k[$i] = i; at = 1; next }
  /^#/ { next }
  { g = $k["dp"]; load = $k["load_x"]; forcing = -$k["forcing_x"] }
  END {
    value["load"] = load / g
    value["forcing"] = forcing / g
    value["sum"] = (load - forcing) / g
    value["drag"] = g / (6 * atan2(0, -1) * a * 1e-3 * 4.29159)
    value["felt"] = value["drag"] * value["load"]
    printf "%.9g\n", value[way] }' series.csv
