#!/usr/bin/env bash
# One pressure solve a step compared with one in each stage: vortices, a block that breaks under a flow, a rigid block.
# usage: cases/verification/projection/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# last STUDY LEVEL QUANTITY: the last stage's number over each stage's
last() { calc "$(cell "$1" value 'last stage' "$2" "$3") / $(cell "$1" value 'each stage' "$2" "$3")"; }
# gap METHOD LEVEL: the error of the drag, N
gap() { calc "$(cell study_forcing value "$1" "$2" drag) - 4.184545"; }
study study
for level in '0.025 s' '0.0125 s'; do
  row "vortices, last stage: order of the energy to $level" 1 "$(cell study order 'last stage' "$level" energy)" 2 \
    "second order" 1.8 2.2
  row "vortices, last stage: order of the dissipation to $level" 1 \
    "$(cell study order 'last stage' "$level" dissipation)" 2 "second order" 1.8 2.2
done
row "vortices, last stage: largest divergence" 1/s "$(cell study value 'last stage' '0.2 s' divergence)" 0 continuity \
  0 1e-11
study study_grid
space=$(calc "$(cell study_grid value 'each stage' 48 energy) / $(cell study_grid value 'each stage' 96 energy) - 1")
row "vortices, last stage, the largest stable step: error of the energy over the error of 48 cells" 1 \
  "$(calc "($(cell study value 'last stage' '0.2 s' energy) / 21.6530983 - 1) / ($space)")" 0 "below a half" -0.5 0.5
study study_forcing
for level in 'N_s = 1' 'N_s = 2' 'N_s = 4'; do
  row "rigid block, $level: error of the drag, last stage over each stage" 1 \
    "$(calc "$(gap 'last stage' "$level") / ($(gap 'each stage' "$level"))")" 0 "no larger" -1 1
done
if [ ! "$quick" ]; then
  study study_block
  row "block, 34 us: drag, last stage over each stage" 1 "$(last study_block '34 us' drag)" 1 "each stage" 0.999 1.001
  for what in '1 % of the bonds' 'share broken at 2.4 ms' 'share broken at 4.8 ms'; do
    row "block, 34 us: $what, last stage over each stage" 1 "$(last study_block '34 us' "$what")" 1 "each stage" \
      0.98 1.02
  done
fi
finish
