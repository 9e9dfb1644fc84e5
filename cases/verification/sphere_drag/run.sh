#!/usr/bin/env bash
# Force on a sphere from forcing, momentum balance and probes; drag in a stream, compared with Schiller and Naumann's
# correlation.
# usage: cases/verification/sphere_drag/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study_probe
for d in 8 16; do
  near "array, $d cells a diameter: forcing over driving" 1 "$(cell study_probe value 2 $d 'forcing over driving')" 1 \
    "balance of forces" 1e-3
  row "array, $d cells a diameter: momentum residual" 1 "$(cell study_probe value 2 $d 'momentum residual')" 0 \
    "momentum of the box" 0 1e-10
  judge=(shown)
  [ $d != 16 ] || judge=(near 0.03)
  "${judge[0]}" "array, $d cells a diameter: load by the probes over driving" 1 \
    "$(cell study_probe value 2 $d 'load over driving')" 1 "balance of forces" "${judge[@]:1}"
  "${judge[0]}" "array, $d cells a diameter: load carried to the wall over driving" 1 \
    "$(cell study_probe value wall $d 'load over driving')" 1 "balance of forces" "${judge[@]:1}"
done
if [ ! "$quick" ]; then
  study study_probe_fine
  near "array, 32 cells a diameter: load by the probes over driving" 1 \
    "$(cell study_probe_fine value 2 32 'load over driving')" 1 "balance of forces" 0.015
  near "array, 32 cells a diameter: load carried to the wall over driving" 1 \
    "$(cell study_probe_fine value wall 32 'load over driving')" 1 "balance of forces" 0.015
  study study_stream
  near "Re = 20, 10 cells a diameter: drag coefficient, 8 diameters across" 1 \
    "$(cell study_stream value '8 diameters across' 10 drag)" 2.610 "Schiller and Naumann" 0.06
  study study_stream_100
  near "Re = 100, 10 cells a diameter: drag coefficient" 1 \
    "$(cell study_stream_100 value '6 diameters across' 10 drag)" 1.092 "Schiller and Naumann" 0.06
fi
finish
