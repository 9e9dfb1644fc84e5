#!/usr/bin/env bash
# Double and mixed precision of the force sweep: breakage of a notched block, momentum and energy of free bodies.
# usage: cases/verification/precision/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# ratio STUDY LEVEL QUANTITY: mixed over double
ratio() { calc "$(cell "$1" value mixed "$2" "$3") / $(cell "$1" value double "$2" "$3")"; }
study study
for level in '4 us' '2 us' '1 us'; do
  row "time of the first bond, mixed over double, step of $level" 1 "$(ratio study "$level" 'first bond')" 1 \
    "double" 0.99 1.01
  row "broken bonds, mixed over double, step of $level" 1 "$(ratio study "$level" 'broken bonds')" 1 "double" 0.98 1.02
  row "fracture energy, mixed over double, step of $level" 1 "$(ratio study "$level" 'fracture energy')" 1 "double" \
    0.98 1.02
done
study study_wave
study study_spin
for level in '4 us' '2 us'; do
  row "waves, mixed, step of $level: change of momentum over that of the motion" 1 \
    "$(cell study_wave value mixed "$level" momentum)" 0 "free body" -1e-7 1e-7
  row "waves, step of $level: change of energy, mixed over double" 1 "$(ratio study_wave "$level" energy)" 1 "double" \
    0.999 1.001
  row "spin, mixed, step of $level: change of momentum over that of the motion" 1 \
    "$(cell study_spin value mixed "$level" momentum)" 0 "free body" -1e-7 1e-7
  row "spin, mixed, step of $level: change of energy less the work" 1 "$(cell study_spin value mixed "$level" energy)" \
    0 "books" -1e-6 1e-6
done
finish
