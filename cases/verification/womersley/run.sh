#!/usr/bin/env bash
# Amplitude and lag of the oscillating flow, on the axis and in the mean, compared with the exact solution.
# usage: cases/verification/womersley/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
reference=([1]="0.463153 22.7129 0.308995 21.7598" [4]="1.112804 88.1417 0.843612 77.9236")
for wo in 1 4; do
  study study_$wo
  read -r -a exact <<<"${reference[wo]}"
  k=0
  for what in 'amplitude of the axis' 'lag of the axis' 'amplitude of the mean velocity' 'lag of the mean velocity'; do
    near "Wo = $wo with 32 cells: $what" "$([ "${what%% *}" = lag ] && echo deg || echo 1)" \
      "$(cell study_$wo value RK3 32 "$what")" "${exact[k]}" "exact solution" 2e-3
    row "Wo = $wo: order to 64 cells: $what" 1 "$(cell study_$wo order RK3 64 "$what")" 2 "second order" 1.95 2.05
    k=$((k + 1))
  done
done
finish
