#!/usr/bin/env bash
# Prints, in a run folder of the bar, the largest force at its driven end over its width, 8, and over E s0 = 6.8228e-4,
# the stress at which the bonds of a homogeneous material with the interface's energy break.
set -euo pipefail
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 && $at["load"] == 0 && $at["index"] == 1 { f = $at["force_x"]; f = f < 0 ? -f : f; if (f > most) most = f }
  END { if (!most) exit 1; print most / 8 / 6.8228e-4 }' reactions.csv
