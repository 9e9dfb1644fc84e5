#!/usr/bin/env bash
# Prints, in the folder of the runs, the deflection (m) of the strut's tip under a load at rest, without the stream.
# usage: alone.sh E LOAD [SPACING]     LOAD: even over the strut, in N, or the method of study.csv whose load on the
#                                      rigid strut it is; or a run's file of particles, whose load on each it is
# shellcheck source=cases/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../../common.sh"
set -euo pipefail
d=${3:-0.001}
if [[ $2 = *.hdf ]]; then
  [ -f "$2" ]
  paste -d ' ' <(h5_values "$2" VTKHDF/Points %.9g 3) <(h5_values "$2" VTKHDF/PointData/displacement %.9g 3) \
    <(h5_values "$2" VTKHDF/PointData/load %.9g 3) | awk -v d="$d" '
    function side(x, u, end) { return (int((x - u) / d + 100) - 100 + (end ? 0.98 : 0.02)) * d } # of a particle at rest
    function box(end) { return "[" side($1, $4, end) ", " side($2, $5, end) ", " side($3, $6, end) "]" }
    $7 || $8 || $9 { printf "    - {low: %s, high: %s, force: [%s, %s, %s]}\n", box(0), box(1), $7, $8, $9 }'
else
  awk -F, -v load="$2" '
    /^#/ { next } !at { for (i = 1; i <= NF; i++) if ($i == "value") at = i; next }
    $1 == load && $2 == "2 kPa" && $4 == "load on the rigid strut" { load = $at }
    END { printf "    - {low: [0.017, 0, 0.009], high: [0.023, 0.024, 0.015], force: [%.12g, 0, 0]}\n",
      load / (36e-6 * 0.024) }' study.csv
fi >loads
sed -e '/{.*force/r loads' -e '/{.*force/d' "$FRANA_STUDY/dry.yaml" >dry.yaml
rm -rf dry
"$FRANA" run dry.yaml --out dry --quiet --set "solid.materials.rubber.youngs_modulus=$1" --set "solid.spacing=$d" >&2
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "displacement_x") at = i } END { print $at }' dry/probes.csv
