#!/usr/bin/env bash
# The job scripts of tools/batch with a real slurmctld and slurmd on this machine: a run is started, signalled ahead of
# its time limit, queued again, resumed and done, and its series is that of an uninterrupted run; a run that is not
# signalled stops by the time that squeue says; a study as an array of jobs gives the tables of a study on one go.
# usage: slurm.sh FRANA SOURCE WORK. Exit code 77: Slurm is not installed (./test.sh --batch installs it).
for command in munged slurmctld slurmd sbatch srun scontrol squeue scancel; do
  PATH=$PATH:/usr/sbin command -v $command >/dev/null || { echo "no $command here" >&2; exit 77; }
done
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/../program/common.sh" "$@"
PATH=$PATH:/usr/sbin
unset "${!SLURM_@}" "${!SBATCH_@}" "${!SRUN_@}" "${!SQUEUE_@}"
export FRANA=$frana LEAST=0
batch=$source/tools/batch

# Munge and Slurm in a folder of their own, run by this user on free ports of this host. It says that it has 16 cores.
home=$(mktemp -d /tmp/frana-slurm.XXXXXX)
chmod 755 "$home"
mkdir -p "$home"/{munge,state,spool}
is_free() { ! (: <>"/dev/tcp/127.0.0.1/$1") 2>/dev/null; }
port=$((20000 + $$ % 20000))
until is_free $port && is_free $((port + 1)); do port=$((port + 2)); done
cat >"$home/slurm.conf" <<CONF
ClusterName=alone
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$home/munge/socket
StateSaveLocation=$home/state
SlurmdSpoolDir=$home/spool
SlurmctldPidFile=$home/slurmctld.pid
SlurmdPidFile=$home/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SchedulerType=sched/builtin
SlurmctldLogFile=$home/controller.log
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,batch_sched_delay=0
NodeName=localhost NodeAddr=127.0.0.1 CPUs=16
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$home/slurm.conf
daemons=()
finish() {
  local status=$?
  scancel --state=PENDING --me 2>/dev/null || true
  scancel --state=RUNNING --me 2>/dev/null || true
  for _ in {1..50}; do [ -n "$(squeue -h 2>/dev/null)" ] || break; sleep 0.1; done
  kill "${daemons[@]}" 2>/dev/null || true
  wait "${daemons[@]}" 2>/dev/null || true
  [ $status = 0 ] || { tail -n 20 "$home"/*.log; cat ./*.out 2>/dev/null; } >&2
  rm -rf "$home"
}
trap finish EXIT
trap "exit 143" TERM INT
(umask 077 && head -c 1024 /dev/urandom >"$home/munge/key")
munged --foreground --key-file="$home/munge/key" --socket="$home/munge/socket" --pid-file="$home/munge/pid" \
  --log-file="$home/munged.log" --seed-file="$home/munge/seed" >"$home/munge.log" 2>&1 & daemons+=($!)
await $! test -S "$home/munge/socket" || fail "munged has ended"
setsid slurmctld -D >"$home/slurmctld.log" 2>&1 & daemons+=($!)
setsid slurmd -D -N localhost >"$home/slurmd.log" 2>&1 & slurmd=$!
daemons+=("$slurmd")
idle() { sinfo -h -o %T 2>/dev/null | grep -qx idle; }
await $slurmd idle || fail "slurmd has ended"

begun=$SECONDS
tell() { echo "$((SECONDS - begun)) s: $*"; }
# job ID FIELD: what Slurm knows of a job
job() { scontrol show job "$1" -o | tr ' ' '\n' | sed -n "s/^$2=//p" | head -n 1; }
state() { job "$1" JobState; }
is() { [ "$(state "$1")" = "$2" ]; }
queued_again() { [ "$(job "$1" Restarts)" = 1 ]; }
# Begins a job that waits again now, and not in two minutes. slurmd refuses a job that was allowed to run in the second
# in which it ended before.
restart() { sleep 2; ! is "$1" PENDING || scontrol update JobId="$1" StartTime=now; }
ended() { case $(state "$1") in COMPLETED | FAILED | CANCELLED | TIMEOUT | NODE_FAIL) ;; *) false ;; esac; }
# done_ ID OUT: the job ends with exit code 0
done_() {
  await $slurmd ended "$1"
  [ "$(state "$1") $(job "$1" ExitCode)" = "COMPLETED 0:0" ] || { cat "$2" >&2; fail "job $1: $(job "$1" ExitCode)"; }
}
# the processes of the run in a folder
processes() {
  local pid
  for pid in $(pgrep -x frana || true); do
    { tr "\0" "\n" <"/proc/$pid/cmdline"; } 2>/dev/null | grep -qx -e "$1" && echo "$pid"
  done
  return 0
}
rows() { [ -e "$1/series.csv" ] && [ "$(wc -l <"$1/series.csv")" -gt 4 ]; }
# hold OUT: stops the processes of a run that has begun, so that it is not done before its signal comes
hold() {
  await $slurmd rows "$1"
  # shellcheck disable=SC2046 # words
  kill -STOP $(processes "$1")
  grep -q '"done"' "$1/run.json" 2>/dev/null && fail "$1: was done before it was held"
  return 0
}
# shellcheck disable=SC2046
go() { kill -CONT $(processes "$1"); }
# pending OUT: SIGUSR1 waits for all processes of the run; signal 10 is the third of the last three digits of the mask
pending() {
  local pid
  for pid in $(processes "$1"); do
    awk '/^(SigPnd|ShdPnd)/ { got = got || substr($2, 14, 1) ~ /[2367abef]/ } END { exit !got }' "/proc/$pid/status" ||
      return 1
  done
}

scene >scene.yaml
code 0 ranks 2 run scene.yaml --out whole
tell "the uninterrupted run is done"

# 1: with srun, signalled by Slurm ahead of a limit of a minute; 2: with mpiexec; 3: without a signal
first=$(sbatch --parsable -o first.out -n 2 -t 1 --signal=B:USR1@15 "$batch/run.slurm" scene.yaml first)
hold first
{ until pending first; do sleep 0.2; done; go first; } & # its limit does not wait for what is tested meanwhile
second=$(LAUNCH="mpiexec -n 2" sbatch --parsable -o second.out -n 2 -t 30 "$batch/run.slurm" scene.yaml second)
hold second
sed '/^#SBATCH --signal/d' "$batch/run.slurm" >quiet.slurm
third=$(RESTARTS=0 sbatch --parsable -o third.out -n 2 -t 1 quiet.slurm scene.yaml third \
  --set stages.fracture.steps=100000000)
hold third
left() { squeue -h -j "$third" -o %L | awk -F: '{ print 60 * $1 + $2 }'; }
{ until [ "$(left)" -le 20 ]; do sleep 0.5; done; go third; } &
tell "three runs have begun"
scancel --batch --signal=USR1 "$second" # to the script alone, as --signal=B does
await $slurmd pending second
go second
await $slurmd queued_again "$second"
grep -q 'stopped by SIGUSR1' second/run.log || fail "second: $(cat second/run.log)"
restart "$second"
done_ "$second" second.out
grep -q '^resumed at step' second/run.log || fail "second: did not resume"
same whole/series.csv second/series.csv
forces whole/reactions.csv second/reactions.csv
tell "with mpiexec: signalled, queued again, resumed, done"

# the study's array meanwhile: its run 1 is signalled and queued again
sed -n '/^cat >scene.yaml/,/^END$/{/^cat/d;/^END$/d;p}' "$source/tests/program/study/program.sh" >bar_scene.yaml
cat >bar.yaml <<'YAML'
title: Energy of a bar
scene: bar_scene.yaml
repeats: 1
launcher: srun --mpi=pmix -n {ranks}
quantity: {name: energy, column: e_kinetic_solid, unit: J, reference: {finest: true, order: 2}}
methods:
  - {name: verlet, set: {stages.pull.integrator: verlet}}
  - {name: rk3, ranks: 2, set: {stages.pull.integrator: rk3}}
levels:
  - {name: "25", size: 2.0e-6, set: {stages.pull.steps: 10000, output.series_every: 500}}
  - {name: "50", size: 1.0e-6}
YAML
lasting() { grep -v '^#' "$1" | cut -d, -f1-11,16,20-23; }
array=$(sbatch --parsable -o array.%a.out --array=1-4 -n 2 -t 30 "$batch/study.slurm" bar.yaml)
collect=$(sbatch --parsable -o collect.out -t 5 --dependency=afterany:"$array" \
  --wrap "$frana study bar.yaml --collect")
run=./results/runs/bar/verlet/25/1
hold $run
scancel --batch --signal=USR1 "${array}_1"
await $slurmd pending $run
go $run
await $slurmd queued_again "${array}_1"
[ "$(state "$collect")" = PENDING ] || fail "the study is collected before its runs are done"
restart "$(job "${array}_1" JobId)"
done_ "$collect" collect.out
cp results/bar.csv array.csv
mkdir one
sed 's/launcher:.*/launcher: mpiexec --oversubscribe -n {ranks}/; s/scene: /scene: ..\//' bar.yaml >one/bar.yaml
code 0 "$frana" study one/bar.yaml
# To 1e-12 and not to the bit: run 1 wrote a checkpoint where it was stopped, which changes the last digits of its next
# steps (docs/design/state.md, "What is forgotten").
awk -F, 'FNR == NR { row[n = FNR] = $0; next }
  { if (split(row[FNR], a, ",") != NF) bad = 1
    for (i = 1; i <= NF; i++) {
      d = a[i] - $i; m = $i < 0 ? -$i : $i
      if (a[i] != $i && ($i !~ /^-?[0-9.]+(e[-+][0-9]+)?$/ || a[i] !~ /^-?[0-9.]+(e[-+][0-9]+)?$/ ||
        (d < 0 ? -d : d) > 1e-12 * m)) bad = 1 } }
  END { exit bad || FNR != n || n < 5 }' <(lasting array.csv) <(lasting one/results/bar.csv) ||
  fail "the array's table is another than that of one go: $(cat array.csv one/results/bar.csv)"
grep -q '^resumed at step' $run/run.log || fail "run 1 of the study did not resume: $(cat $run/run.log)"
grep -q '^rk3,50,.*,2,1,0,done$' array.csv || fail "rows: $(cat array.csv)"
tell "the array's study is that of one go"

# Slurm's own signal ahead of the limit
await $slurmd queued_again "$first"
tell "Slurm has sent SIGUSR1"
grep -q 'stopped by SIGUSR1' first/run.log || fail "first: $(cat first/run.log)"
grep -Eq 'the batch system ends this job in (0\.[5-9]|1\b)' first/run.log ||
  fail "squeue's answer is not in first/run.log: $(cat first/run.log)"
restart "$first"
done_ "$first" first.out
grep -q '^resumed at step' first/run.log || fail "first: did not resume"
same whole/series.csv first/series.csv
forces whole/reactions.csv first/reactions.csv
tell "with srun: signalled by Slurm, queued again, resumed, done"
[ "$(ls first/fields)" = "$(ls whole/fields)" ] || fail "other fields than of the uninterrupted run"
# once more: the same job for a run that is done
again=$(sbatch --parsable -o again.out -n 2 -t 1 "$batch/run.slurm" scene.yaml first)
done_ "$again" again.out
grep -q 'this run is done' again.out || fail "again: $(cat again.out)"

# the third run knows its limit from squeue alone
await $slurmd ended "$third"
[ "$(job "$third" ExitCode)" = 75:0 ] || { cat third.out >&2; fail "third: $(job "$third" ExitCode)"; }
grep -q "stopped by the batch system's limit" third/run.log || fail "third: $(cat third/run.log)"
grep -q 'which is the limit' third.out || fail "third: $(cat third.out)"
tell "without a signal: stopped by the limit that squeue said"
echo ok
