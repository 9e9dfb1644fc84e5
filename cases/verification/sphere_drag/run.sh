#!/usr/bin/env bash
# Force on a sphere by each load, from forcing and momentum balance; drag of an array against Zick and Homsy, and in a
# stream against Schiller and Naumann's correlation.
# usage: cases/verification/sphere_drag/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
array() { # array STUDY CELLS TOLERANCE: the numbers of an array; without TOLERANCE the loads are only shown
  local study=$1 d=$2 judge=(shown) method
  near "array, $d cells a diameter: forcing over driving" 1 \
    "$(cell "$study" value reaction "$d" 'forcing over driving')" 1 "balance of forces" 1e-3
  row "array, $d cells a diameter: momentum residual" 1 "$(cell "$study" value reaction "$d" 'momentum residual')" 0 \
    "momentum of the box" 0 1e-10
  [ -z "${3-}" ] || judge=(near "$3")
  for method in reaction $([ "$d" = 32 ] || echo held) 2 wall; do
    "${judge[0]}" "array, $d cells a diameter: load by $(
      case $method in reaction) echo reaction ;; held) echo "reaction, elastic and held" ;; 2) echo "the probes" ;;
        wall) echo "the probes, carried to the wall" ;; esac) over driving" 1 \
      "$(cell "$study" value "$method" "$d" 'load over driving')" 1 "balance of forces" "${judge[@]:1}"
  done
  [ "$d" = 32 ] ||
    shown "array, $d cells a diameter: load by reaction, elastic and held, less the forcing, over driving" 1 \
    "$(cell "$study" value held "$d" 'load and forcing')" 0 "inertia of the inner fluid"
}
order() { # order STUDY STUDY COARSE FINE: of the drag of the array
  calc "log($(cell "$1" error reaction "$3" drag) / $(cell "$2" error reaction "$4" drag)) / log($4 / $3)"
}
study study_probe
array study_probe 8
array study_probe 16 0.02
near "array, 16 cells a diameter: drag over the reference" 1 "$(cell study_probe value reaction 16 drag)" 1 \
  "Zick and Homsy 1982" 0.02
if [ ! "$quick" ]; then
  study study_probe_fine
  array study_probe_fine 32 0.005
  near "array, 32 cells a diameter: drag over the reference" 1 "$(cell study_probe_fine value reaction 32 drag)" 1 \
    "Zick and Homsy 1982" 0.005
  shown "array: order of the drag from 8 to 16 cells a diameter" 1 "$(order study_probe study_probe 8 16)" 2 \
    "second order"
  row "array: order of the drag from 16 to 32 cells a diameter" 1 "$(order study_probe study_probe_fine 16 32)" 2 \
    "second order" 1.7
  study study_loads
  study study_stream
  near "Re = 20, 10 cells a diameter: drag coefficient, 8 diameters across" 1 \
    "$(cell study_stream value '8 diameters across' 10 drag)" 2.610 "Schiller and Naumann" 0.06
  study study_stream_100
  near "Re = 100, 10 cells a diameter: drag coefficient" 1 \
    "$(cell study_stream_100 value '6 diameters across' 10 drag)" 1.092 "Schiller and Naumann" 0.06
fi
finish
