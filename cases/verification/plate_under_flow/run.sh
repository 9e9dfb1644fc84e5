#!/usr/bin/env bash
# A strut in a slow stream: it bends as under the load that it feels when rigid; a stiff strut feels the rigid load.
# usage: cases/verification/plate_under_flow/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# alone E LOAD [SPACING]: deflection of the tip under a uniform load, without the stream
alone() {
  rm -rf "$runs/dry"
  "$frana" run "$here/dry.yaml" --out "$runs/dry" --quiet --set "solid.materials.rubber.youngs_modulus=$1" \
    --set solid.spacing="${3:-0.001}" --set "solid.loads[0].force=[$(calc "$2 / (36e-6 * 0.024)"), 0, 0]" >&2
  (cd "$runs/dry" && "$here/tip.sh")
}
rigid='load on the rigid strut' exact=2.2176e-5
study study
for method in reaction probe; do
  load=$(cell study value $method '2 kPa' "$rigid")
  tip=$(cell study value $method '2 kPa' tip)
  near "$method: load on the rigid strut" N "$load" $exact "gradient times the volume of the fluid" 0.01
  near "$method, 2 kPa: load" N "$(cell study value $method '2 kPa' 'load in the end')" $exact \
    "gradient times the volume of the fluid" 0.01
  row "$method, 2 kPa: tip over the strut's height" 1 "$(calc "$tip / 0.024")" "" "small" 0 0.01
  near "$method, 2 kPa: tip" m "$tip" "$(kept "alone at 2e3, $method" alone 2e3 "$load")" \
    "the solid alone under the rigid strut's load" 0.03
  near "$method, 200 kPa: load" N "$(cell study value $method '200 kPa' 'load in the end')" "$load" \
    "the rigid strut's" 0.005
done
[ "$quick" ] || {
  study study_grid
  departures=()
  for cells in 6 12; do
    tip=$(cell study_grid value reaction $cells tip)
    against=$(kept "alone at 2e3, $cells cells" alone 2e3 $exact "$(calc "0.006 / $cells")")
    shown "reaction, 2 kPa, $cells cells across: tip" m "$tip" "$against" "the solid alone under the exact load"
    departures+=("($(calc "$tip / $against - 1"))")
  done
  row "reaction, 2 kPa: order of the deflection, 6 to 12 cells" 1 \
    "$(calc "log(sqrt((${departures[0]} / ${departures[1]}) ^ 2)) / log(2)")" 2 "at least" 1.5
  study study_soft
  load=$(cell study value reaction '2 kPa' "$rigid")
  departures=()
  for level in '2e3 2 kPa' '1e3 1 kPa' '500 500 Pa' '250 250 Pa'; do
    tip=$(cell study_soft value reaction "${level#* }" tip)
    against=$(kept "alone at ${level%% *}" alone "${level%% *}" "$load")
    departures+=("($(calc "$tip / $against - 1"))")
    shown "reaction, ${level#* }: tip, $(calc "int($tip / 0.024 * 1000 + 0.5) / 10") % of the height" m "$tip" \
      "$against" "the solid alone under the rigid strut's load"
  done
  d=("${departures[@]}")
  row "reaction: power of the deflection that the departure grows with" 1 \
    "$(calc "log((${d[3]} - ${d[0]}) / (${d[2]} - ${d[0]})) / log(2)")" 2 "symmetry" 1.9 2.1
}
finish
