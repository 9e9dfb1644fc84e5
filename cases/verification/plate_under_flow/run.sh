#!/usr/bin/env bash
# A strut in a slow stream: it bends as under the load that it feels when rigid; a stiff strut feels the rigid load.
# usage: cases/verification/plate_under_flow/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# alone E LOAD: deflection of the tip under a uniform load, without the stream
alone() {
  rm -rf "$runs/dry"
  "$frana" run "$here/dry.yaml" --out "$runs/dry" --quiet --set "solid.materials.rubber.youngs_modulus=$1" \
    --set "solid.loads[0].force=[$(calc "$2 / (36e-6 * 0.024)"), 0, 0]" >&2
  (cd "$runs/dry" && "$here/tip.sh")
}
rigid='load on the rigid strut'
study study
load=$(cell study value probe '2 kPa' "$rigid")
tip=$(cell study value probe '2 kPa' tip)
row "probe, 2 kPa: tip over the strut's height" 1 "$(calc "$tip / 0.024")" "" "small" 0 0.01
near "probe, 2 kPa: tip" m "$tip" "$(kept "alone at 2e3" alone 2e3 "$load")" \
  "the solid alone under the rigid strut's load" 0.03
near "probe, 200 kPa: load" N "$(cell study value probe '200 kPa' 'load in the end')" "$load" "the rigid strut's" 0.005
shown "probe: load on the rigid strut" N "$load" 2.2176e-5 "gradient times the volume of the fluid"
[ "$quick" ] || {
  study study_soft
  departures=()
  for level in '2e3 2 kPa' '1e3 1 kPa' '500 500 Pa' '250 250 Pa'; do
    tip=$(cell study_soft value probe "${level#* }" tip)
    against=$(kept "alone at ${level%% *}" alone "${level%% *}" "$load")
    departures+=("($(calc "$tip / $against - 1"))")
    shown "probe, ${level#* }: tip, $(calc "int($tip / 0.024 * 1000 + 0.5) / 10") % of the height" m "$tip" "$against" \
      "the solid alone under the rigid strut's load"
  done
  d=("${departures[@]}")
  row "probe: power of the deflection that the departure grows with" 1 \
    "$(calc "log((${d[3]} - ${d[0]}) / (${d[2]} - ${d[0]})) / log(2)")" 2 "symmetry" 1.9 2.1
  study study_balanced
  load=$(cell study_balanced value balanced '2 kPa' "$rigid")
  shown "balanced: load on the rigid strut" N "$load" 2.2176e-5 "gradient times the volume of the fluid"
  near "balanced, 2 kPa: tip" m "$(cell study_balanced value balanced '2 kPa' tip)" \
    "$(kept "alone at 2e3, balanced" alone 2e3 "$load")" "the solid alone under the rigid strut's load" 0.03
}
finish
