#!/usr/bin/env bash
# A bar with a column of fluid in front of it: frequency and growth with the loads by reaction and by probes, over the
# ratio of densities.
# usage: cases/verification/fluid_column/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
dry() {
  rm -rf "$runs/dry"
  "$frana" run "$here/dry.yaml" --out "$runs/dry" --quiet >&2
  (cd "$runs/dry" && "$here/swing.sh" frequency)
}
DRY=$(kept "the bar alone: angular frequency" dry)
export DRY
shown "the bar alone: angular frequency" rad/s "$DRY" "$(calc 'pi / 2 / 0.016 * sqrt(1.2 * 1.02041 * 1.0e6 / 1000)')" \
  "a bar of 16 spacings without ends"
# What may be left of the exact solution's amplitude of 1 after a period, and in the second half of 6000 and of 42000
# steps over the first. The fluid's share phi of the inertia, 1 - (w/w_dry)^2, acts with an error of first order in the
# step, which damps at most as exp(-phi w^2 dt t/2).
declare -A period=([10]=0.9792 [3]=0.9533 [1]=0.9361 [0.5]=0.9303) \
  short=([10]=0.8441 [2]=0.5452 [1]=0.4700 [0.5]=0.4283) long=([10]=0.3053 [2]=0.01431 [1]=0.005069 [0.5]=0.002645)
study study
for ratio in 10 3 1 0.5; do
  near "probe, rho_s/rho_f = $ratio: frequency over the exact one" 1 \
    "$(cell study value probe $ratio 'frequency over the exact one')" 1 "exact solution" 0.03
  row "probe, rho_s/rho_f = $ratio: amplitude after a period" 1 \
    "$(cell study value probe $ratio 'amplitude after a period')" 1 "decays with the step's order" "${period[$ratio]}" 1
done
[ "$quick" ] || {
  study study_reaction
  for ratio in 10 2 1 0.5; do
    near "reaction, rho_s/rho_f = $ratio: frequency over the exact one" 1 \
      "$(cell study_reaction value reaction $ratio 'frequency over the exact one')" 1 "exact solution" 0.02
    what='later over earlier displacement'
    row "reaction, rho_s/rho_f = $ratio: $what" 1 "$(cell study_reaction value reaction $ratio "$what")" 1 \
      "decays with the step's order" "${short[$ratio]}" 1
    row "reaction, rho_s/rho_f = $ratio: $what across" 1 \
      "$(cell study_reaction value reaction $ratio "$what across")" 1 \
      "round-off adds up in proportion" 0 2
  done
  study study_long
  for ratio in 10 2 1 0.5; do
    what='later over earlier displacement'
    row "reaction, rho_s/rho_f = $ratio, a hundred periods: $what" 1 \
      "$(cell study_long value reaction $ratio "$what")" 1 \
      "decays with the step's order" "${long[$ratio]}" 1
    row "reaction, rho_s/rho_f = $ratio, a hundred periods: $what across" 1 \
      "$(cell study_long value reaction $ratio "$what across")" 1 "round-off adds up in proportion" 0 2
  done
  study study_edge
  for step in '40 us' '10 us' '2.5 us'; do
    what='later over earlier displacement'
    row "probe, $step, rho_s/rho_f = 2: $what" 1 "$(cell study_edge value "$step" 2 "$what")" 1 "holds" 0 1
    ran=$(cell study_edge value "$step" 1.7 "$what")
    row "probe, $step, rho_s/rho_f = 1.7: $what" 1 "${ran:-1e9}" 1 "holds (1e9: the run ends as unstable)" 0 1
  done
}
finish
