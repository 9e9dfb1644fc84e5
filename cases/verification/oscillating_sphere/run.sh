#!/usr/bin/env bash
# Force on an oscillating sphere, in phase with its velocity and with its acceleration.
# usage: cases/verification/oscillating_sphere/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
gates() { # gates STUDY METHOD LEVEL RADIUS_OVER_DELTA BOX TOLERANCE_IN_PHASE TOLERANCE_OUT_OF_PHASE
  local exact
  read -r -a exact <<<"$("$here/box.sh" "$4" "$5")"
  near "a/delta = $4, $2, $3 cells: in phase" 1 "$(cell "$1" value "$2" "$3" "in phase")" "${exact[0]}" \
    "Stokes 1851 in the box" "$6"
  near "a/delta = $4, $2, $3 cells: out of phase" 1 "$(cell "$1" value "$2" "$3" "out of phase")" "${exact[1]}" \
    "Stokes 1851 in the box" "$7"
  near "a/delta = $4, $2, $3 cells: in phase by the probe" 1 "$(cell "$1" value "$2" "$3" "in phase by the probe")" \
    "${exact[0]}" "Stokes 1851 in the box" "$6"
  near "a/delta = $4, $2, $3 cells: out of phase by the probe" 1 \
    "$(cell "$1" value "$2" "$3" "out of phase by the probe")" "${exact[1]}" "Stokes 1851 in the box" "$7"
}
if [ "$quick" ]; then
  study study
  for method in lattice shape; do gates study $method 8 1 8 0.1 0.15; done
else
  study study_1
  study study_4
  study study_4_fine
  study study_box
  study study_step
  for method in lattice shape; do
    gates study_1 $method 8 1 8 0.1 0.15
    gates study_1 $method 16 1 8 0.05 0.08
  done
  gates study_4 shape 16 4 6 0.1 0.08
  for what in "in phase" "out of phase"; do
    near "a/delta = 4, lattice, 16 cells: $what" 1 "$(cell study_4 value lattice 16 "$what")" \
      "$("$here/box.sh" 4 6 | cut -d' ' -f"$([ "$what" = "in phase" ] && echo 1 || echo 2)")" \
      "Stokes 1851 in the box" "$([ "$what" = "in phase" ] && echo 0.1 || echo 0.08)"
  done
  gates study_4_fine shape 32 4 6 0.05 0.05
  for box in 6 8 12; do # the box is taken out when what is left is the same in all of them
    read -r -a exact <<<"$("$here/box.sh" 1 $box)"
    for k in 0 1; do
      what=$([ $k = 0 ] && echo "in phase" || echo "out of phase")
      ours=$(cell study_box value lattice $box "$what")
      shown "a/delta = 1, 8 cells, a box of $box radii: $what over Stokes without a box" 1 \
        "$(calc "$ours / $([ $k = 0 ] && echo 2 || echo 1.2222222)")" 1 "Stokes 1851"
      row "a/delta = 1, 8 cells, a box of $box radii: $what over Stokes in the box, against that in 12 radii" 1 \
        "$(calc "$ours / ${exact[k]} / ($(cell study_box value lattice 12 "$what") / $(
          "$here/box.sh" 1 12 | cut -d' ' -f$((k + 1))))")" 1 "the first reflection" 0.98 1.02
    done
  done
  for step in 2.5e-3 1.25e-3 6.25e-4; do
    for what in "in phase" "in phase with the lag" "out of phase" "out of phase with the lag"; do
      shown "a/delta = 1, 8 cells, a step of $step: $what" 1 "$(cell study_step value lattice $step "$what")" \
        "$("$here/box.sh" 1 8 | cut -d' ' -f"$([ "${what%% *}" = in ] && echo 1 || echo 2)")" "Stokes 1851 in the box"
    done
  done
fi
finish
