#!/usr/bin/env bash
# frana study without a reference: curves against a swept key, bands over the members of an ensemble.
# usage: sweep.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/../common.sh" "$@"
sed -n '/^cat >scene.yaml/,/^END$/{/^cat/d;/^END$/d;p}' "$source/tests/program/study/program.sh" >scene.yaml
said() { grep -q -e "$1" "$2" || fail "not said: $1: $(cat "$2")"; }
# cell STUDY COLUMN METHOD LEVEL QUANTITY
cell() {
  awk -F, -v column="$2" -v at="$3,$4" -v quantity="$5" '/^#/ { next }
    !head { for (i = 1; i <= NF; i++) c[$i] = i; head = 1; next }
    $1 "," $2 == at && $4 == quantity { print $c[column] }' "results/$1.csv"
}
near() { awk -v a="$1" -v b="$2" -v within="$3" 'BEGIN { exit !(a - b < within * b && b - a < within * b) }'; }

# A bar at rest that a force starts to move: its work grows with the force's square and falls with the density. Five
# forces are the ensemble, so its median, quartiles and range are those of 1, 4, 9, 16 and 25 times the least.
cat >forces.yaml <<'YAML'
title: A bar by density
scene: scene.yaml
set: {stages.pull.steps: 4, stages.pull.time_step: 1.0e-7}
sweep: {key: solid.materials.any.density, values: [1500, 3000, 6000], name: density, unit: kg/m3}
ensemble: {key: "solid.loads[0].force", values: [[5e5, 0, 0], [1e5, 0, 0], [4e5, 0, 0], [2e5, 0, 0], [3e5, 0, 0]]}
quantities:
  - {name: energy, column: e_kinetic_solid, unit: J}
  - {name: steps, command: 'tail -1 series.csv | cut -d, -f1'}
YAML
code 0 "$frana" study forces.yaml --list
[ "$(wc -l <out)" = 15 ] || fail "the list: $(cat out)"
code 0 "$frana" study forces.yaml
said '^\[1/15\] all, 1500, solid.loads\[0\].force=\[5e5, 0, 0\]: .*energy' out
least=$(cell forces least all 3000 energy)
for k in lower=4 value=9 upper=16 most=25 mean=11; do
  near "$(cell forces ${k%=*} all 3000 energy)" "$(awk -v a="$least" -v k=${k#*=} 'BEGIN { print a * k }')" 1e-3 ||
    fail "${k%=*} is $(cell forces ${k%=*} all 3000 energy), least $least"
done
four=$(awk -v a="$(cell forces value all 6000 energy)" 'BEGIN { print 4 * a }')
near "$(cell forces value all 1500 energy)" "$four" 2e-3 || fail "densities: $(cat results/forces.csv)"
[ "$(cell forces values all 6000 steps) $(cell forces at all 6000 steps) $(cell forces status all 6000 steps)" = \
  "5 6000 done" ] || fail "steps: $(cat results/forces.csv)"
[ "$(grep -c 'energy,J,.*,done,./results/runs/forces/all/' results/forces_runs.csv)" = 15 ] ||
  fail "the table of runs: $(cat results/forces_runs.csv)"
grep -qi 'error\|costs' results/forces.csv && fail "a sweep speaks of errors: $(cat results/forces.csv)"
grep -v 'claims no error' results/forces.md | grep -qi 'error\|costs' && fail "errors: $(cat results/forces.md)"
grep -q '^[$]band0 << EOD' results/forces_energy.gp || fail "no band is drawn"
grep -q 'density  \[kg/m3\]' results/forces_energy.gp || fail "the axis has no name"
code 0 "$frana" study forces.yaml
said '15 runs, 15 of them made before' out
# a threshold that two of the five do not reach: the band is that of three, and says so
above=$(awk -v a="$least" 'BEGIN { print 6 * a }')
sed -e "s/^quantities:/&\n  - {name: reached, column: e_kinetic_solid, at: time, above: $above}/" \
  -e 's/values: \[1500, 3000, 6000\]/values: [3000]/' forces.yaml >reached.yaml
code 0 "$frana" study reached.yaml
[ "$(cell reached values all 3000 reached), $(cell reached status all 3000 reached)" = "3, 2 without a value" ] ||
  fail "values that are not reached: $(cat results/reached.csv)"
said '| 3 | .* | 2 without a value |' results/reached.md

# most runs are missing: nothing made, one point, two points; no warning of gnuplot reaches the user
mkdir few && cp scene.yaml forces.yaml few && cd few
collect() { # collect TEXT: exit code 75, a last line with this text, and none by anyone else than frana
  code 75 "$frana" study forces.yaml --collect
  said "$1" err
  ! grep -v '^frana: ' err || fail "another program speaks: $(cat err)"
}
collect 'forces.yaml: none of the 15 runs has been made, so there is nothing to report$'
code 0 "$frana" study forces.yaml --run 1
collect 'forces.yaml: 14 of 15 runs are missing'
[ -s results/forces.csv ] && [ ! -e results/forces_energy.gp ] || fail "one point is drawn, or has no row"
! grep -q plots out || fail "plots are said to be there: $(cat out)"
code 0 "$frana" study forces.yaml --run 6
collect 'forces.yaml: 13 of 15 runs are missing'
[ -e results/forces_energy.gp ] || fail "two points are not drawn"
said 'plots, of 2 runs' out
cd ..

# an ensemble alone, as jobs of their own: one member fails, and the others are made and counted
cat >steps.yaml <<'YAML'
scene: scene.yaml
set: {stages.pull.integrator: verlet, stages.pull.substeps: 1}
ensemble: {key: stages.pull.time_step, values: [1.0e-6, 1.0e-1, 5.0e-7]}
quantity: {name: time, column: t}
YAML
code 0 "$frana" study steps.yaml --run 1
code 3 "$frana" study steps.yaml --run 2
code 75 "$frana" study steps.yaml --collect
said '1 of 3 runs are missing: 3$' err
[ "$(cell steps status all all time)" = '1 failed; 1 not run' ] || fail "half: $(cat results/steps.csv)"
code 0 "$frana" study steps.yaml --run 3
code 0 "$frana" study steps.yaml --collect
[ "$(cell steps values all all time) $(cell steps failed all all time) $(cell steps status all all time)" = \
  "2 1 1 failed" ] || fail "an ensemble with a member that failed: $(cat results/steps.csv)"
near "$(cell steps value all all time)" 3.75e-5 1e-9 || fail "median of 50 and 25 us: $(cat results/steps.csv)"
[ ! -e results/steps.gp ] || fail "a plot without an axis"

# points that set several keys, two methods, no ensemble
cat >points.yaml <<'YAML'
scene: scene.yaml
methods: [{name: soft}, {name: stiff, set: {solid.materials.any.youngs_modulus: 2.0e8}}]
sweep:
  name: time
  points:
    - {at: 1, set: {stages.pull.steps: 10, stages.pull.time_step: 1.0e-7}}
    - {at: 10, set: {stages.pull.steps: 5, stages.pull.time_step: 2.0e-6}}
quantity: {column: t}
YAML
code 0 "$frana" study points.yaml
said '4 runs, 0 of them made before' out
near "$(cell points value stiff 10 t)" 1e-5 1e-9 || fail "points: $(cat results/points.csv)"
grep -q '^[$]band' results/points.gp && fail "a band of one run"
# a gnuplot that never answers: SIGTERM ends the study while it draws
mkdir mute && printf '#!/bin/sh\n: >drawing\nexec cat >/dev/null\n' >mute/gnuplot && chmod +x mute/gnuplot
PATH=$PWD/mute:$PATH "$frana" study points.yaml --collect >out 2>err &
study=$!
await $study test -e drawing || fail "ended before it drew: $(cat out err)"
kill -TERM $study
for _ in $(seq 100); do kill -0 $study 2>/dev/null || break; sleep 0.1; done
kill -KILL $study 2>/dev/null && fail "SIGTERM does not end a study that draws"
got=0 && wait $study || got=$?
[ $got = 75 ] && [ -z "$(find results -maxdepth 1 -name '*.part')" ] || fail "ended with $got, and left: $(ls results)"
# stopped while it reads the runs: no table of what was not read
cp points.yaml whole.yaml && rm results/points.csv
sed -i "s|^quantity.*|quantity: {name: t, unit: s, command: ': >$PWD/reading; exec sleep 60'}|" points.yaml
"$frana" study points.yaml --collect >out 2>err &
study=$!
await $study test -e reading || fail "ended before it read: $(cat out err)"
kill -TERM $study
got=0 && wait $study || got=$?
[ $got = 75 ] && grep -q 'stopped while the runs were read' err || fail "a study that reads: $got, $(cat out err)"
[ ! -e results/points.csv ] || fail "a table of what was not read"
mv whole.yaml points.yaml
# a link and a pipe where a run's output goes
echo precious >outside
for make in "ln -s $PWD/outside" mkfifo; do
  rm -rf results/runs/points/soft/1/1 && mkdir -p results/runs/points/soft/1/1
  $make results/runs/points/soft/1/1/screen.log
  code 4 timeout -s KILL 60 "$frana" study points.yaml
  grep -q '^frana: .*screen.log: cannot be written: it is ' err && [ "$(cat outside)" = precious ] || fail "$(cat err)"
done
rm results/runs/points/soft/1/1/screen.log
code 0 "$frana" study points.yaml
# a title that turns the terminal's writing
sed '1i title: "a\\u202eb\\e[31m"' points.yaml >turned.yaml
code 2 "$frana" study turned.yaml --list
grep -q 'turned.yaml:1: title = "a *b *\[31m": must be one line without control characters' err || fail "$(cat -v err)"
got=0 && "$frana" study points.yaml --list >/dev/full 2>err || got=$?
[ $got = 4 ] || fail "a list that cannot be written: $got"
code 0 "$frana" study points.yaml --collect
echo ok
