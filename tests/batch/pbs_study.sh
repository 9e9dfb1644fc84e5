#!/usr/bin/env bash
# The job script tools/batch/study.pbs, with a stand-in for qsub and the variables that a PBS server sets: an array of
# OpenPBS and one of Torque; SIGUSR1 ahead of the limit, the run submitted alone, resumed; the table of a study on one
# go; no endless chain of jobs.
# usage: pbs_study.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/../program/common.sh" "$@"
sed -n '/^cat >scene.yaml/,/^END$/{/^cat/d;/^END$/d;p}' "$source/tests/program/study/program.sh" >bar_scene.yaml
cat >bar.yaml <<'YAML'
title: Energy of a bar
scene: bar_scene.yaml
repeats: 1
launcher: mpiexec --oversubscribe -n {ranks}
quantity: {name: energy, column: e_kinetic_solid, unit: J, reference: {finest: true, order: 2}}
methods:
  - {name: verlet, set: {stages.pull.integrator: verlet}}
  - {name: rk3, ranks: 2, set: {stages.pull.integrator: rk3}}
levels:
  - {name: "25", size: 2.0e-6, set: {stages.pull.steps: 5000, output.series_every: 500}}
  - {name: "50", size: 1.0e-6}
YAML
mkdir fake
# shellcheck disable=SC2016 # for the stand-in
printf '#!/bin/sh\necho "$*" >>submitted\n' >fake/qsub
chmod +x fake/qsub
export PATH=$PWD/fake:$PATH PBS_O_WORKDIR=$PWD LC_ALL=C
edit() { # LIMIT LEAST: the copy that a user makes
  sed "s|^frana=.*|frana=$frana|; s|^study=.*|study=bar.yaml|; s|^least=.*|least=$2|; s|^limit=.*|limit=$1|" \
    "$source/tools/batch/study.pbs" >study.pbs
}
submitted() { cat submitted 2>/dev/null || true; }
# the columns that do not depend on the machine's speed
lasting() { grep -v '^#' "$1" | cut -d, -f1-11,16,20-23; }

edit 86100 0
code 2 bash study.pbs
grep -q '^usage' err || fail "outside of an array: $(cat err)"

# run 1 is longer than its job: signalled, submitted alone
cp bar.yaml whole.yaml
sed -i 's/steps: 5000/steps: 100000000/' bar.yaml
edit 4 60
PBS_ARRAY_INDEX=1 code 75 bash study.pbs
grep -q 'is its time longer' err && [ -z "$(submitted)" ] || fail "a job that was too short: $(cat err; submitted)"
run=results/runs/bar/verlet/25/1
grep -q 'stopped by SIGUSR1' $run/run.log || fail "not signalled: $(cat $run/run.log)"
edit 4 0
PBS_ARRAY_INDEX=1 code 75 bash study.pbs
[ "$(submitted)" = '-v FRANA_RUN=1,FRANA_RESTARTS=1 study.pbs' ] || fail "submitted: $(submitted)"
# the job for run 1 alone; the variables of an array do not reach it, and would not matter
FRANA_RUN=1 FRANA_RESTARTS=1 PBS_ARRAY_INDEX=3 code 75 bash study.pbs
[ "$(submitted | tail -n 1)" = '-v FRANA_RUN=1,FRANA_RESTARTS=2 study.pbs' ] || fail "submitted: $(submitted)"
[ ! -e results/runs/bar/rk3 ] || fail "another run was made: $(ls results/runs/bar)"
FRANA_RUN=1 FRANA_RESTARTS=100 code 75 bash study.pbs
[ "$(submitted | wc -l)" = 2 ] && grep -q 'which is the limit' err || fail "an endless chain: $(submitted)"
grep -q '^resumed at step' $run/run.log || fail "run 1 did not resume: $(cat $run/run.log)"

# a study whose runs end: the array of OpenPBS, then that of Torque, then the collection
rm -r results submitted
mv whole.yaml bar.yaml
edit 86100 0
for k in 1 2; do PBS_ARRAY_INDEX=$k code 0 bash study.pbs; done
code 75 "$frana" study bar.yaml --collect
grep -q '2 of 4 runs are missing: 3,4$' err || fail "half an array: $(cat err)"
for k in 3 4; do PBS_ARRAYID=$k code 0 bash study.pbs; done
[ -z "$(submitted)" ] || fail "done, and submitted again: $(submitted)"
code 0 "$frana" study bar.yaml --collect
mkdir one
sed 's/scene: /scene: ..\//' bar.yaml >one/bar.yaml
code 0 "$frana" study one/bar.yaml
diff <(lasting results/bar.csv) <(lasting one/results/bar.csv) || fail "the tables differ"
grep -q '^rk3,50,.*,2,1,0,done$' results/bar.csv || fail "rows: $(cat results/bar.csv)"
echo ok
