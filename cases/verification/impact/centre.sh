#!/usr/bin/env bash
# Prints, in a run folder of disc.yaml, the stress at the centre over 2 F/(pi D): xx along, yy across. Needs h5dump.
# usage: centre.sh xx|yy
# shellcheck disable=SC2016 # awk in single quotes
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../common.sh"
file=$(printf '%s\n' fields/solid_*.hdf | tail -n 1)
force=$(awk -F, "$names"' $k["index"] == 1 { f = $k["force_y"] } END { print f }' reactions.csv)
paste -d ' ' <(h5_values "$file" VTKHDF/Points %.6g 3) <(h5_values "$file" VTKHDF/PointData/stress %.9g 6) |
  awk -v f="$force" -v what="$1" '($1 - 35.5) ^ 2 + ($2 - 35.5) ^ 2 < 0.01 {
    pi = atan2(0, -1); printf "%.10g\n", $(what == "xx" ? 4 : 5) / (2 * f / (pi * 60)); n++ } END { exit n != 1 }'
