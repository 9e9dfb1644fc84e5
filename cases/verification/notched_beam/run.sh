#!/usr/bin/env bash
# A notched beam bent slowly at three points: load against opening, energy that the creeping crack takes.
# usage: cases/verification/notched_beam/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

# of_beam OFFSET WHAT [STEPS [INCREMENT]]: a number of the beam whose lattice is moved by OFFSET spacings
of_beam() {
  local to=$runs/beam_$1_${4:-0.01}
  ! is_done "$to" || [ ! "$to/run.json" -ot "$frana" ] || rm -rf "${to:?}"
  is_done "$to" || {
    rm -rf "${to:?}"
    "$frana" run "$here/scene.yaml" --set "solid.lattice_offset=[$1, 0]" \
      --set "stages.bend.steps=${3:-18}" --set "stages.bend.increment=${4:-0.01}" --out "$to" >"$to.log" 2>&1 ||
      { cat "$to.log" >&2; return 1; }
  }
  (cd "$to" && awk -F, -v what="$2" -f "$here/curve.awk" reactions.csv probes.csv crack.csv series.csv)
}
for offset in 0.5 0.2; do
  [ ! "$quick" ] || [ $offset = 0.5 ] || continue
  name="notch $offset off a row"
  at_most "$name: opening over load before anything breaks, less 1" 1 \
    "$(kept "$name: compliance" of_beam $offset compliance)" 0 "Tada, with the notch as deep as the tip is read" 0.03
  row "$name: depth of the notch by its opening" spacings "$(kept "$name: depth" of_beam $offset depth)" 16 \
    "as drawn" 15 17
  at_most "$name: distance of the crack's tip from the depth by its opening" spacings \
    "$(kept "$name: follows" of_beam $offset follows)" 0 "" 1.5
  near "$name: largest load" "sqrt(E G0) W^1.5/(S f)" "$(kept "$name: peak" of_beam $offset peak)" 1 \
    "Griffith, a notch of 16" 0.1
  near "$name: energy that the creeping crack takes" G0 "$(kept "$name: taken" of_beam $offset taken)" 1 "G0" 0.1
  shown "$name: G at the largest load" G0 "$(kept "$name: onset" of_beam $offset onset)" 1 "G0"
  shown "$name: energy of the bonds that the creeping crack breaks" G0 \
    "$(kept "$name: broken" of_beam $offset broken)" 1 "G0"
  shown "$name: depth at the end" spacings "$(kept "$name: last" of_beam $offset last)" "" ""
done
if [ ! "$quick" ]; then
  shown "notch 0.5 off a row, increments of 0.02: energy that the creeping crack takes" G0 \
    "$(kept "0.02: taken" of_beam 0.5 taken 9 0.02)" 1 "G0"
  shown "notch 0.5 off a row, increments of 0.02: energy of the bonds that it breaks" G0 \
    "$(kept "0.02: broken" of_beam 0.5 broken 9 0.02)" 1 "G0"
fi
finish
