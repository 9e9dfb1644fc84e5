#!/usr/bin/env bash
# Prints, in a run folder, the drag coefficient of a sphere of diameter 1 in a stream of speed 1, from the probes (load)
# or from the forcing. usage: drag.sh load|forcing
awk -F, -v way="$1" '!at { for (i = 1; i <= NF; i++) if ($i == way "_x") at = i; next } /^#/ { next }
  { f = (way == "load" ? 1 : -1) * $at } END { printf "%.9g\n", 8 * f / atan2(0, -1) }' series.csv
