#!/usr/bin/env bash
# The job script tools/batch/run.pbs, with stand-ins for qsub and qstat in place of a PBS server: SIGUSR1 ahead of the
# limit, submitted again, resumed, done; what qstat says of the time; no endless chain of jobs.
# usage: pbs.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/../program/common.sh" "$@"
scene >scene.yaml
mkdir fake
# shellcheck disable=SC2016 # for the stand-in
printf '#!/bin/sh\necho "$*" >>submitted\n' >fake/qsub
# shellcheck disable=SC2016
printf '#!/bin/sh\n[ "$*" = "-f 12.server" ] || exit 1
echo "Job Id: 12.server"\necho "    Resource_List.walltime = 24:00:00"\n'\
'echo "    stime = $(date "+%%a %%b %%d %%T %%Y")"\n' >fake/qstat
chmod +x fake/*
export PATH=$PWD/fake:$PATH PBS_O_WORKDIR=$PWD PBS_JOBID=12.server LC_ALL=C
edit() { # the copy that a user makes
  sed "s|^frana=.*|frana=$frana|; s|^launch=.*|launch=(mpiexec --oversubscribe -n 2)|
    s|^least=.*|least=$2|; s|^limit=.*|limit=$1|" \
    "$source/tools/batch/run.pbs" >run.pbs
}
submitted() { cat submitted 2>/dev/null || true; }

edit 86100 0
code 0 ranks 2 run scene.yaml --out whole
sed -i 's/name: fracture, steps: [0-9]*/name: fracture, steps: 100000000/' scene.yaml
grep -q 'steps: 100000000' scene.yaml || fail "the scene was not changed"
edit 5 60
code 75 bash run.pbs
grep -q 'is its time longer' err && [ -z "$(submitted)" ] || fail "a job that was too short: $(cat err; submitted)"
grep -q 'the batch system ends this job in 14[34][0-9.]* min' runs/mine/run.log ||
  fail "qstat's answer: $(cat runs/mine/run.log)"
grep -q 'stopped by SIGUSR1' runs/mine/run.log || fail "not signalled: $(cat runs/mine/run.log)"
edit 5 0
code 75 bash run.pbs
[ "$(submitted)" = '-v FRANA_RESTARTS=1 run.pbs' ] || fail "submitted: $(submitted)"
FRANA_RESTARTS=100 code 75 bash run.pbs
[ "$(submitted | wc -l)" = 1 ] && grep -q 'which is the limit' err || fail "an endless chain: $(submitted)"
# done: nothing is submitted
step=$(sed -n 's/.*"stage_step": \([0-9]*\).*/\1/p' runs/mine/run.json)
sed -i "s/steps: 100000000/steps: $((step + 20))/" scene.yaml
edit 86100 0
code 0 bash run.pbs
code 0 bash run.pbs
grep -q 'this run is done' out && [ "$(submitted | wc -l)" = 1 ] || fail "done: $(cat out; submitted)"
echo ok
