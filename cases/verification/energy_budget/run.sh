#!/usr/bin/env bash
# The energy budget of a coupled run, over the energy that is put in, at three time steps.
# usage: cases/verification/energy_budget/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study
study study_still
study study_break
steps=("400 us" "200 us" "100 us")
for method in reaction probe; do
  for step in "${steps[@]}"; do
    row "in a stream, $method, rigid, $step: not accounted for" 1 "$(cell study value $method "$step" rigid)" 0 \
      "share of the gradient's work" -0.01 0.01
    row "in a stream, $method, $step: not accounted for" 1 "$(cell study value $method "$step" whole)" 0 \
      "share of the gradient's work" -0.01 0.01
  done
done
for step in '200 us' '100 us'; do
  judge=(shown)
  [ "$step" != "100 us" ] || judge=(row 1) # the finest step is judged
  for method in reaction probe; do
    row "in a stream, $method, $step: order of the solid's books" 1 "$(cell study order $method "$step" solid)" 1 \
      "at least" 1
    for what in rigid whole; do
      "${judge[0]}" "in a stream, $method, ${what/whole/let go}, $step: order of what is not accounted for" 1 \
        "$(cell study order $method "$step" $what)" 1 "at least" "${judge[@]:1}"
    done
  done
  for method in reaction probe balanced; do
    row "at rest, $method, $step: order of the solid's books" 1 "$(cell study_still order $method "$step" solid)" 1 \
      "at least" 1
    "${judge[0]}" "at rest, $method, $step: order of what is not accounted for" 1 \
      "$(cell study_still order $method "$step" whole)" 1 "at least" "${judge[@]:1}"
  done
done
for method in reaction probe balanced; do
  for step in "${steps[@]}"; do
    judge=(shown)
    [ "$step" != "100 us" ] || judge=(row -0.01 0.01)
    "${judge[0]}" "at rest, $method, $step: not accounted for" 1 "$(cell study_still value $method "$step" whole)" 0 \
      "share of the energy at the start" "${judge[@]:1}"
  done
  shown "at rest, $method, 100 us: work of the fluid on the solid" 1 "$(cell study_still value $method '100 us' work)" \
    "" "share of the energy at the start"
done
for method in reaction probe; do
  shown "breaking, $method, 400 us: broken bonds" 1 "$(cell study_break value $method '400 us' 'broken bonds')" "" \
    "of 54670"
  row "breaking, $method, 400 us: not accounted for" 1 "$(cell study_break value $method '400 us' whole)" 0 \
    "share of the gradient's work" -0.01 0.01
  row "breaking, $method, 400 us: the solid's books" 1 "$(cell study_break value $method '400 us' solid)" 0 \
    "share of the gradient's work" -0.01 0.01
done
finish
