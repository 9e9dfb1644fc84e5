#!/usr/bin/env bash
# Prints, in a run folder, the force on the body by the probes (load) or by the forcing, over the force that drives the
# flow, dp times the box's section of 1 m2. usage: load.sh load|forcing
awk -F, -v way="$1" '
  !dp { for (i = 1; i <= NF; i++) { if ($i == way "_x") at = i; if ($i == "dp") dp = i } next }
  /^#/ { next }
  { ratio = (way == "load" ? 1 : -1) * $at / $dp } END { printf "%.9g\n", ratio }' series.csv
