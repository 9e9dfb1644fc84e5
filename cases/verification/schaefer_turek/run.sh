#!/usr/bin/env bash
# Drag, lift, pressure drop, eddies and vortex shedding of a cylinder in a channel.
# usage: cases/verification/schaefer_turek/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
drag=5.57953523 lift=0.010618948 drop=0.11752017 source=FeatFlow
gates() { # gates STUDY METHOD LEVEL TOLERANCE_OF_DRAG TOLERANCE_OF_DROP; lift and eddies at 40 cells: the range of 1996
  local range="0.0053 0.0212" judge=(shown)
  [ "$3" != 40 ] || { range="0.0104 0.0110"; judge=(row 0.0842 0.0852); }
  near "2D-1, $2, $3 cells: drag" 1 "$(cell "$1" value "$2" "$3" drag)" $drag "$source" "$4"
  near "2D-1, $2, $3 cells: pressure drop" Pa "$(cell "$1" value "$2" "$3" "pressure drop")" $drop "$source" "$5"
  # shellcheck disable=SC2086 # two words
  row "2D-1, $2, $3 cells: lift" 1 "$(cell "$1" value "$2" "$3" lift)" $lift "$source" $range
  "${judge[0]}" "2D-1, $2, $3 cells: length of the eddies" m \
    "$(cell "$1" value "$2" "$3" "length of the eddies")" 0.0847 "Schaefer and Turek 1996: 0.0842 to 0.0852" \
    "${judge[@]:1}"
}
if [ "$quick" ]; then
  study study
  for method in lattice shape; do gates study $method 10 0.08 0.05; done
else
  study study_fine
  study study_long
  study study_100
  [ "$again" ] || {
    cp "$here/scene_3d.yaml" "$here/study_3d.yaml" "$here/measure.sh" "$runs"
    "$here/inflow.sh" 41 >"$runs/inflow.txt"
  }
  here=$runs study study_3d
  study study_40
  study study_wall
  for level in 10 20; do
    for method in probe wall; do
      near "2D-1, eight cells across, $level cells: drag by the probe, load $method" 1 \
        "$(cell study_wall value $method $level "drag by the probe")" $drag "$source" \
        "$([ $level = 10 ] && echo 0.08 || echo 0.04)"
    done
  done
  for method in lattice shape; do
    gates study_fine $method 10 0.08 0.05
    gates study_fine $method 20 0.04 0.03
    for level in 10 20; do
      near "2D-2, $method, $level cells: largest drag" 1 "$(cell study_100 value $method $level "largest drag")" 3.23 \
        "Schaefer and Turek 1996: 3.22 to 3.24" "$([ $level = 10 ] && echo 0.08 || echo 0.04)"
      row "2D-2, $method, $level cells: largest lift" 1 "$(cell study_100 value $method $level "largest lift")" 1 \
        "Schaefer and Turek 1996: 0.99 to 1.01" 0.5 2
      row "2D-2, $method, $level cells: Strouhal number" 1 "$(cell study_100 value $method $level "Strouhal number")" \
        0.3 "Schaefer and Turek 1996: 0.295 to 0.305" 0.295 0.305
      near "2D-2, $method, $level cells: pressure drop half a period later" Pa \
        "$(cell study_100 value $method $level "pressure drop half a period later")" 2.48 \
        "Schaefer and Turek 1996: 2.46 to 2.50" "$([ $level = 10 ] && echo 0.05 || echo 0.03)"
    done
    near "3D-1Z, $method, 10 cells: drag" 1 "$(cell study_3d value $method 10 drag)" 6.18533 "FeatFlow" 0.08
    near "3D-1Z, $method, 10 cells: pressure drop" Pa "$(cell study_3d value $method 10 "pressure drop")" 0.170826996 \
      "FeatFlow" 0.05
    row "3D-1Z, $method, 10 cells: lift" 1 "$(cell study_3d value $method 10 lift)" 0.009401 "FeatFlow" 0.0047 0.0188
  done
  gates study_40 shape 40 0.015 0.015
  for what in drag lift "pressure drop"; do
    near "2D-1, 10 cells: $what, half the length and half the time" 1 "$(cell study_fine value lattice 10 "$what")" \
      "$(cell study_long value lattice 10 "$what")" "the longer run" 5e-3
  done
fi
finish
