#!/usr/bin/env bash
# frana study --list, --run, --collect: the runs of a study as jobs of their own give the tables of a study on one go.
# usage: array.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/../common.sh" "$@"
sed -n '/^cat >scene.yaml/,/^END$/{/^cat/d;/^END$/d;p}' "$source/tests/program/study/program.sh" >scene.yaml
cat >bar.yaml <<'YAML'
title: Energy of a bar
scene: scene.yaml
repeats: 2
quantities:
  - {name: energy, column: e_kinetic_solid, unit: J, reference: {finest: true, order: 2}}
  - {name: end, command: 'tail -1 series.csv | cut -d, -f2', reference: {value: 6.0e-5}}
methods:
  - {name: verlet, set: {stages.pull.integrator: verlet}}
  - name: wild
    ranks: 2
    set: {stages.pull.integrator: verlet, stages.pull.substeps: 1, stages.pull.time_step: 1.0e-1}
levels:
  - {name: "25", size: 2.0e-6, set: {stages.pull.steps: 25}}
  - {name: "50", size: 1.0e-6}
YAML
study() { "$frana" study bar.yaml "$@"; }
said() { grep -q -e "$1" "$2" || fail "not said: $1: $(cat out err)"; }
# the columns that do not depend on the machine's speed
lasting() { grep -v '^#' "$1" | cut -d, -f1-11,16,20-23; }

code 0 study --list
wanted=$(for k in 1 2 3 4 5 6 7 8; do echo "$k missing $((2 - k % 2))"; done)
[ "$(cut -d' ' -f1-3 out)" = "$wanted" ] ||
  fail "the list: $(cat out)"
[ ! -e results ] || fail "a list makes a folder"

# each run by itself, in any order and at once; a table of half of them says what is missing
code 3 study --run 2
"$frana" study bar.yaml --run 4 >fourth 2>&1 & fourth=$!
code 0 study --run 1
got=0; wait $fourth || got=$?
[ $got = 3 ] || fail "run 4 ended with $got: $(cat fourth)"
said '^\[1/8\] verlet, 25, repeat 1: .*energy [0-9]' out
code 75 study --collect
said '3 of 8 runs are missing: 3,5,7$' err
grep -q '^verlet,50,.*,not run$' results/bar.csv || fail "no row says not run: $(cat results/bar.csv)"
code 0 study --run 3
code 0 study --run 6 # left out, as run 2 has failed
said 'left out, as an earlier repeat has failed' out
before=$(stat -c %Y,%i results/runs/bar/verlet/25/1/run.json)
code 0 study --run 1 # is there
said 'kept' out
[ "$(stat -c %Y,%i results/runs/bar/verlet/25/1/run.json)" = "$before" ] || fail "run 1 was made again"
for k in 5 7; do code 0 study --run $k; done
code 0 study --collect
cp results/bar.csv collected.csv
code 0 study --list
[ "$(cut -d' ' -f2 out | tr '\n' ' ')" = 'done failed done failed done missing done missing ' ] ||
  fail "the list: $(cat out)"

# the same tables as on one go, from the same runs and from new ones
code 0 study
said '8 runs, 6 of them made before' out
diff <(grep -v '^# date' collected.csv) <(grep -v '^# date' results/bar.csv) || fail "one go over the same runs"
code 0 study --out once
diff <(lasting collected.csv) <(lasting once/bar.csv) || fail "one go in another folder"
grep -q '^verlet,50,1e-06,energy,.*,done$' collected.csv && grep -q '^wild,25,.*,failed 3$' collected.csv ||
  fail "rows: $(cat collected.csv)"
for f in results once; do [ -s $f/bar.md ] && [ -s $f/bar_energy.gp ] || fail "no page or plot in $f"; done

# stopped by the batch system's limit, and gone on with: the same series; the time of all its steps
mkdir fake
printf '#!/bin/sh\necho 0:05\n' >fake/squeue
chmod +x fake/squeue
sed -i 's/steps: 25/steps: 5000/; /series_every/s/5,/1000,/' bar.yaml scene.yaml
code 0 study --run 1 --out whole
got=0
SLURM_JOB_ID=7 PATH=$PWD/fake:$PATH study --run 1 >out 2>err || got=$?
[ $got = 75 ] || fail "ended with $got in a job without time: $(cat out err)"
said '^stopped at run 1 of 8: the same command goes on' out
run=results/runs/bar/verlet/25/1
grep -q "by the batch system's limit" $run/run.log || fail "not by the limit: $(cat $run/run.log)"
code 0 study --run 1
grep -q '"resumed_at_step": [1-9]' $run/run.json || fail "it did not go on: $(cat $run/run.json)"
same whole/runs/bar/verlet/25/1/series.csv $run/series.csv
grep -q '"wall_seconds_earlier": [0-9]' $run/run.json || fail "no time of the steps before: $(cat $run/run.json)"

# SIGUSR1 is handed on, and a run at work is not touched
sed -i 's/steps: 5000/steps: 100000000/' bar.yaml
"$frana" study bar.yaml --run 5 >fifth 2>&1 & fifth=$!
await $fifth grep -qs '^stage pull: 100000000' results/runs/bar/verlet/25/2/run.log || fail "run 5: $(cat fifth)"
code 4 study --run 5
said 'another run is at work there' err
kill -USR1 $fifth
got=0; wait $fifth || got=$?
[ $got = 75 ] || fail "run 5 ended with $got: $(cat fifth)"
[ -f results/runs/bar/verlet/25/2/checkpoint/latest ] || fail "run 5 has no checkpoint"

code 2 study --run 9
said 'bar.yaml has 8 runs' err
code 2 study --run 0
code 2 study --run 1 --collect
said 'only one of them' err
code 2 study --fresh --list
echo ok
