#!/usr/bin/env bash
# The first steps after an impulsive start: the load on a cube in a stream that starts at once, over the step, and the
# cube's strain energy with and without a stage of the flow alone before.
# usage: cases/stability/start/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../../verification/common.sh" "$@"
# shellcheck source=cases/stability/edge.sh
. "$here/../edge.sh"
point() { # point STEP WAIT: the flow alone for WAIT seconds, then elastic for 4 s
  local dir=$runs/at/$1-$2
  made "$dir" scene stages.flow.time_step="$1" stages.elastic.time_step="$1" \
    stages.flow.steps="$(calc "int($2 / $1 + 0.5)")" \
    stages.elastic.steps="$(calc "int(4 / $1 + 0.5)")" || { echo "$1,$2,nan,nan,nan,nan"; return; }
  echo "$1,$2,$(of_run "$dir" load_x 'print x[1]'),$(of_run "$dir" load_x 'print x[n]'),$(
    of_run "$dir" e_strain 'print max(1, n)'),$(of_run "$dir" e_strain 'print x[n]')"
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR > 2 {
    print $2 "," $at["load_x"] "," $at["e_strain"] }' "$dir/series.csv" >"$runs/load_$1_$2.csv"
}
printf '%s\n' "0.2 0" "0.1 0" "0.05 0" "0.025 0" "0.1 0.1" "0.1 0.5" "0.1 2" "0.1 8" >"$runs/points"
table start 'step,wait,first_load,last_load,most_strain_energy,last_strain_energy' <"$runs/points"
[ "$again" ] || cp "$runs"/load_*.csv "$out"
for step in 0.1 0.05 0.025; do
  near "impulse of the first step at $step s over that at twice the step" 1 \
    "$(calc "$(in_table start $step 0 3) / 2 / $(in_table start "$(calc "2 * $step")" 0 3)")" 1 \
    "an impulse has no step in it" 0.05
done
row "largest strain energy after five rigid steps over that without" 1 \
  "$(calc "$(in_table start 0.1 0.5 5) / $(in_table start 0.1 0 5)")" "" "five steps take up the impulse" 0 0.1
plot start
finish
