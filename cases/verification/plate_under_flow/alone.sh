#!/usr/bin/env bash
# Prints, in the folder of the runs, the deflection (m) of the strut's tip under a uniform load, without the stream.
# usage: alone.sh E LOAD [SPACING]     LOAD: in N, or the method of study.csv whose load on the rigid strut it is
set -euo pipefail
load=$(awk -F, -v load="$2" '
  /^#/ { next } !at { for (i = 1; i <= NF; i++) if ($i == "value") at = i; next }
  $1 == load && $2 == "2 kPa" && $4 == "load on the rigid strut" { load = $at }
  END { printf "%.12g\n", load / (36e-6 * 0.024) }' study.csv)
rm -rf dry
"$FRANA" run "$FRANA_STUDY/dry.yaml" --out dry --quiet --set "solid.materials.rubber.youngs_modulus=$1" \
  --set "solid.spacing=${3:-0.001}" --set "solid.loads[0].force=[$load, 0, 0]" >&2
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "displacement_x") at = i } END { print $at }' dry/probes.csv
