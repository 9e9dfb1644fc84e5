#!/usr/bin/env bash
# Prints, in a run folder, the energy that bonds released over the crack's way and G0 (1e-6), a line through all
# samples with the tip between x = 24 and 50 by least squares; `speed`: the tip's, in the same way.
set -euo pipefail
awk -F, -v what="$1" -v depth="${2:-1}" '
  FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  FNR < 3 || $at["tip_x"] < 24 || $at["tip_x"] > 50 { next }
  { x = $at["tip_x"]; y = what == "speed" ? $at["t"] : $at["e_fracture"]
    n++; sx += x; sy += y; sxx += x * x; sxy += x * y; last = x }
  END {
    if (n < 10 || last < 44) exit 1
    slope = (n * sxy - sx * sy) / (n * sxx - sx * sx)
    print what == "speed" ? 1 / slope : slope / depth / 1e-6
  }' crack.csv
