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
# The cells by which a load on its markers finds the bar longer than its frequency does: the displacement of the markers
# at rest, 1.24 of the outermost layer's less 0.24 of the next one's, times C11, less the length that acts
skin() {
  rm -rf "$runs/loaded"
  "$frana" run "$here/loaded.yaml" --out "$runs/loaded" --quiet >&2
  awk -F, -v dry="$DRY" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 { x[$at["probe"]] = $at["displacement_x"] }
    END { pi = atan2(0, -1); c11 = 1.2 * 1.02041 * 1.0e6
      printf "%.6g\n", ((1.24 * x[0] - 0.24 * x[1]) * c11 - pi / 2 * sqrt(c11 / 1000) / dry) / 0.001 }' \
    "$runs/loaded/probes.csv"
}
DRY=$(kept "the bar alone: angular frequency" dry)
export DRY
SKIN=$(kept "the bar alone: softness under the load of its markers" skin)
export SKIN
shown "the bar alone: angular frequency" rad/s "$DRY" "$(calc 'pi / 2 / 0.016 * sqrt(1.2 * 1.02041 * 1.0e6 / 1000)')" \
  "a bar of 16 spacings without ends"
shown "the bar alone: cells that a load on its markers finds it longer" 1 "$SKIN" 0 "a bar without a skin"
# What may be left of the exact solution's amplitude of 1 after a period by the probe's load, and by the load by
# reaction in the second half of 42000 steps over the first. The fluid's share phi of the inertia, 1 - (w/w_dry)^2, acts
# with an error of first order in the step, which damps at most as exp(-phi w^2 dt t/2).
declare -A period=([10]=0.9792 [3]=0.9533 [1]=0.9361 [0.5]=0.9303) \
  long=([10]=0.3053 [2]=0.01431 [1]=0.005069 [0.5]=0.002645)
study study
for ratio in 10 3 1 0.5; do
  near "probe, rho_s/rho_f = $ratio: frequency over the exact one" 1 \
    "$(cell study value probe $ratio 'frequency over the exact one')" 1 "exact solution" 0.03
  row "probe, rho_s/rho_f = $ratio: amplitude after a period" 1 \
    "$(cell study value probe $ratio 'amplitude after a period')" 1 "decays with the step's order" "${period[$ratio]}" 1
done
study study_step
row "reaction, from 20 to 5 us: order of the frequency's change" 1 "$(
  f() { cell study_step value reaction "$1" 'frequency over the exact one'; }
  calc "log(($(f 10) - $(f 20)) / ($(f 5) - $(f 10))) / log(2)")" 2 "the step" 1
[ "$quick" ] || {
  study study_reaction
  for column in 3.5 1.5 0.75; do
    for ratio in 10 3 1.5 1 0.5; do
      name="reaction, L/l = $column, rho_s/rho_f = $ratio"
      near "$name: frequency over the exact one" 1 \
        "$(cell study_reaction value $column $ratio 'frequency over the exact one')" 1 "exact solution" 0.015
      row "$name: amplitude after a period" 1 \
        "$(cell study_reaction value $column $ratio 'amplitude after a period')" 1 \
        "exact solution; measured to 0.1 %" 0.97 1.001
    done
  done
  study study_grid
  row "reaction, 16 to 32 cells: order of the frequency's error" 1 \
    "$(cell study_grid order reaction 32 'frequency over the exact one')" 1 "at least" 1
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
