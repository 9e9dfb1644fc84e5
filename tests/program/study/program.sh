#!/usr/bin/env bash
# frana study: two methods by two levels; interrupted and resumed, changed, failed; and all its output.
# usage: program.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/../common.sh" "$@"
cat >scene.yaml <<'END'
title: A short bar, pulled
domain: {size: [0.016, 0.004, 0.004]}
solid:
  spacing: 1.0e-3
  materials: [{name: any, youngs_modulus: 1.0e8, density: 3000}]
  bodies: [{name: bar, shape: box, low: [0, 0, 0], high: [0.016, 0.004, 0.004]}]
  constraints: [{low: [0, 0, 0], high: [0.003, 0.004, 0.004], directions: xyz}]
  loads: [{low: [0.013, 0, 0], high: [0.016, 0.004, 0.004], force: [1.0e6, 0, 0]}]
stages: [{name: pull, steps: 50, time_step: 1.0e-6}]
output: {series_every: 5, fields_every: 0, checkpoint_every: 0}
END
cat >bar.yaml <<'END'
title: Energy of a bar
scene: scene.yaml
repeats: 1
quantities:
  - {name: energy, column: e_kinetic_solid, unit: J, reference: {finest: true, method: rk3, order: 3}}
  - {name: end, command: 'echo "$FRANA_STUDY" >where; tail -1 series.csv | cut -d, -f2', reference: {value: 6.0e-5}}
methods:
  - {name: verlet, set: {stages.pull.integrator: verlet}}
  - {name: rk3, ranks: 2, set: {stages.pull.integrator: rk3}}
levels:
  - {name: "25", size: 2.0e-6, set: {stages.pull.time_step: 2.0e-6, stages.pull.steps: 25}}
  - {name: "50", size: 1.0e-6}
END
stamps() { stat -c '%n %Y %i' results/runs/bar/*/*/*/run.json; }
# column NAME METHOD LEVEL QUANTITY: a cell of the table
column() {
  awk -F, -v name="$1" -v m="$2" -v l="$3" -v q="$4" '
    /^#/ { next }
    !at { for (i = 1; i <= NF; i++) if ($i == name) at = i; next }
    $1 == m && $2 == l && $4 == q { print $at }' results/bar.csv
}

# stopped during a run that would take minutes; finished runs are not repeated
cp bar.yaml whole.yaml
sed -i '/name: "50"/s/}/, set: {stages.pull.steps: 100000000}}/' bar.yaml
rm -f out
"$frana" study bar.yaml >out 2>err & study=$!
await $study grep -qs '^\[2/4\]' out || fail "two runs are not done: $(cat out err)"
kill -INT $study
got=0; wait $study || got=$?
[ $got = 75 ] && grep -q '^stopped at run 3 of 4' out || fail "stopped with $got: $(cat out err)"
[ ! -e results/bar.csv ] || fail "a table of half a study"
[ ! -e results/runs/bar/verlet/50/1/run.json ] || ! grep -q '"done"' results/runs/bar/verlet/50/1/run.json ||
  fail "it was not stopped"
mv whole.yaml bar.yaml
before=$(stamps | grep '/25/')
code 0 "$frana" study bar.yaml
grep -q '4 runs, 2 of them made before' out || fail "resumed: $(cat out)"
[ "$(stamps | grep '/25/')" = "$before" ] || fail "a finished run was made again"
[ "$(cat results/runs/bar/rk3/50/1/where)" = "$PWD" ] || fail "FRANA_STUDY"

# the table
for what in machine compiler frana libraries date 'reference of energy' 'advice on energy'; do
  grep -q "^# $what: " results/bar.csv || fail "no line of $what"
done
for m in verlet rk3; do
  for l in 25 50; do
    [ "$(column status $m $l energy)" = 'done' ] || fail "status of $m $l"
    [ "$(column value $m $l end)" = 5e-05 ] || fail "end of $m $l: $(column value $m $l end)"
    for c in wall_median_s wall_min_s setup_s ns_per_bond_sweep memory_mb; do
      awk -v x="$(column $c $m $l energy)" 'BEGIN { exit !(x + 0 > 0) }' ||
        fail "$c of $m $l: $(column $c $m $l energy)"
    done
  done
done
[ "$(column ranks verlet 25 energy) $(column ranks rk3 25 energy)" = "1 2" ] || fail "ranks"
[ "$(column steps rk3 25 energy) $(column steps rk3 50 energy)" = "25 50" ] || fail "steps"
# the energy is that of the series
[ "$(tail -1 results/runs/bar/rk3/50/1/series.csv | tr , '\n' | grep -cx "$(column value rk3 50 energy)")" -ge 1 ] ||
  fail "value of rk3 50"
awk -v a="$(column error verlet 25 energy)" -v b="$(column error verlet 50 energy)" '
  BEGIN { exit !(a > 3 * b && b > 0) }' ||
  fail "verlet's error does not fall: $(column error verlet 25 energy) $(column error verlet 50 energy)"
grep -q '^| rk3 | 50 |' results/bar.md && grep -q 'given order 3.00' results/bar.md ||
  fail "the page: $(cat results/bar.md)"
if command -v gnuplot >/dev/null; then
  for f in bar_energy bar_end; do [ -s results/$f.png ] && [ -s results/$f.svg ] || fail "no plot $f"; done
fi

# a second study: no run is made; another scene, ranks or build: only the affected runs; --fresh: all runs
before=$(stamps)
code 0 "$frana" study bar.yaml
[ "$(stamps)" = "$before" ] || fail "a finished study was made again"
sed -i 's/density: 3000/density: 3001/' scene.yaml
sed -i '/name: rk3/s/}}/, solid.materials.any.density: 3000}}/' bar.yaml
code 0 "$frana" study bar.yaml
grep -q '4 runs, 2 of them made before' out || fail "another density: $(cat out)"
sed -i 's/"revision": .*/"revision": "another",/' results/runs/bar/verlet/25/1/run.json
sed -i 's/"status": "done"/"status": "running"/' results/runs/bar/verlet/50/1/run.json
sed -i 's/rk3, ranks: 2/rk3, ranks: 1/' bar.yaml
code 0 "$frana" study bar.yaml
grep -q '4 runs, 0 of them made before' out || fail "another build, half a run, other ranks: $(cat out)"
code 0 "$frana" study bar.yaml
grep -q '4 runs, 4 of them made before' out || fail "after another build: $(cat out)"
code 0 "$frana" study bar.yaml --fresh
grep -q '4 runs, 0 of them made before' out || fail "fresh: $(cat out)"

# a method with unstable runs does not stop the others, and is not tried again
wild='{name: wild, set: {stages.pull.integrator: verlet, stages.pull.substeps: 1, stages.pull.time_step: 1.0e-1}}'
sed -i "/name: rk3/i \\  - $wild" bar.yaml
sed -i '/name: "25"/s/stages.pull.time_step: 2.0e-6, //; s/repeats: 1/repeats: 2/' bar.yaml
code 0 "$frana" study bar.yaml
[ "$(column status wild 25 energy)" = "failed 3" ] || fail "status of wild: $(cat results/bar.csv)"
[ "$(column status rk3 50 energy)" = 'done' ] || fail "rk3 after wild"
[ "$(column repeats rk3 50 energy) $(column value_spread rk3 50 energy)" = "2 0" ] || fail "repeats of rk3"
[ "$(grep -c 'wild.*left out, as an earlier repeat has failed' out)" = 2 ] || fail "wild was repeated: $(cat out)"
grep -q '2 runs have failed' err || fail "failures are not said: $(cat err)"
code 0 "$frana" study bar.yaml
grep -q '12 runs, 10 of them made before' out || fail "wild again: $(cat out)"

# mistakes: one sentence with the line, exit code 2, and no run is made
refuses() {
  sed "$2" bar.yaml >broken.yaml
  code 2 "$frana" study broken.yaml --out none
  [ "$(grep -c '^frana: ' err)" = 1 ] && grep -q -e "$1" err || fail "sed $2: $(cat err)"
  [ ! -e none ] || fail "sed $2: something was run"
}
refuses 'broken.yaml:3: repeats = none: must be a whole number' 's/repeats: 2/repeats: none/'
refuses 'broken.yaml:12: verlet at level 25: .*steps = few: must be a whole number' \
  's/stages.pull.steps: 25/stages.pull.steps: few/'
refuses 'broken.yaml:2: scene = gone.yaml: cannot be read' 's/scene.yaml/gone.yaml/'
refuses 'broken.yaml:9: the names a.b and a.b differ only' 's/name: verlet/name: a b/; s/name: wild/name: a?b/'
code 2 "$frana" study bar.yaml scene.yaml
code 2 "$frana" run scene.yaml --fresh
code 2 ranks 2 study bar.yaml
sed 's/column: e_kinetic_solid/column: e_kinetic_sold/' bar.yaml >broken.yaml
code 2 "$frana" study broken.yaml
grep -q 'broken.yaml:5: .*has no column e_kinetic_sold; did you mean' err || fail "a wrong column: $(cat err)"
