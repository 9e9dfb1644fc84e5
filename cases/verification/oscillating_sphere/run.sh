#!/usr/bin/env bash
# Force on an oscillating sphere, in phase with its velocity and with its acceleration.
# usage: cases/verification/oscillating_sphere/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# gates STUDY METHOD LEVEL RADIUS_OVER_DELTA BOX IN_PHASE OUT_OF_PHASE: the two numbers by the forcing and by the load,
# with these tolerances
gates() {
  local exact of by k
  read -r -a exact <<<"$("$here/box.sh" "$4" "$5")"
  for by in "" " by the load"; do
    for k in 0 1; do
      of=$([ $k = 0 ] && echo "in phase" || echo "out of phase")
      near "a/delta = $4, $2, $3 cells: $of$by" 1 "$(cell "$1" value "$2" "$3" "$of$by")" "${exact[k]}" \
        "Stokes 1851 in the box" "$([ $k = 0 ] && echo "$6" || echo "$7")"
    done
  done
}
old_loads() { # old_loads STUDY LEVEL RADIUS_OVER_DELTA BOX: the loads by probes, shown
  local exact of k method
  read -r -a exact <<<"$("$here/box.sh" "$3" "$4")"
  for method in probe wall; do
    for k in 0 1; do
      of=$([ $k = 0 ] && echo "in phase" || echo "out of phase")
      shown "a/delta = $3, $method, $2 cells: $of by the load" 1 "$(cell "$1" value $method "$2" "$of by the load")" \
        "${exact[k]}" "Stokes 1851 in the box"
    done
  done
}
if [ "$quick" ]; then
  study study
  for method in lattice shape; do gates study $method 8 1 8 0.1 0.15; done
else
  study study
  study study_1
  study study_4
  study study_4_fine
  study study_4_step
  study study_box
  study study_step
  for method in lattice shape; do
    gates study_1 $method 8 1 8 0.1 0.15
    gates study_1 $method 16 1 8 0.05 0.05
    gates study_4 $method 16 4 6 0.05 0.05
  done
  gates study_4_fine shape 32 4 6 0.05 0.05
  read -r -a exact <<<"$("$here/box.sh" 4 6)"
  near "a/delta = 4, shape, 16 cells, half the step: in phase by the load" 1 \
    "$(cell study_4_step value shape 1.25e-3 "in phase by the load")" "${exact[0]}" "Stokes 1851 in the box" 0.05
  near "a/delta = 4, shape, 16 cells, half the step: out of phase by the load" 1 \
    "$(cell study_4_step value shape 1.25e-3 "out of phase by the load")" "${exact[1]}" "Stokes 1851 in the box" 0.05
  old_loads study 8 1 8
  old_loads study_4 16 4 6
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
    for what in "in phase" "out of phase"; do
      shown "a/delta = 1, 8 cells, a step of $step: $what" 1 "$(cell study_step value lattice $step "$what")" \
        "$("$here/box.sh" 1 8 | cut -d' ' -f"$([ "${what%% *}" = in ] && echo 1 || echo 2)")" "Stokes 1851 in the box"
    done
  done
fi
finish
