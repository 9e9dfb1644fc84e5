#!/usr/bin/env bash
# A run stopped anywhere and resumed on another number of ranks gives the same series; ranks do not matter either.
# usage: resume.sh FRANA SOURCE WORK [SEED]: of the steps at which the run is stopped
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# The number of substeps follows contact and is part of the state.
scene | sed 's/substeps: 4/substeps: auto/' >scene.yaml
code 0 ranks 2 run scene.yaml --out whole
grep -q '"status": *"done"' whole/run.json || fail "run.json does not say done"
rows=$(($(wc -l <whole/series.csv) - 2))
[ "$rows" = 12 ] || fail "$rows rows in the series, not 12"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "bonds_broken") b = i }
  END { exit !($b > 0) }' whole/series.csv ||
  fail "nothing has broken: the resumed fracture would not be tested"

for n in 1 $(by_day "" 3); do
  code 0 ranks $n run scene.yaml --out ranks$n
  same whole/series.csv ranks$n/series.csv
  forces whole/reactions.csv ranks$n/reactions.csv
done

# stopped at a random step by a signal, resumed on other ranks until done
RANDOM=${4:-1}
echo "seed ${4:-1}"
# The step of the series' last row, 0 without one.
last() {
  local step
  step=$(tail -n 1 stopped/series.csv 2>/dev/null | cut -d, -f1) || true
  case "$step" in '' | *[!0-9]*) echo 0 ;; *) echo "$step" ;; esac
}
reached() { [ "$(last)" -ge "$1" ]; }
n=2
rm -rf stopped
stops=0
resume=
while :; do
  got=0
  target=$(($(last) + 15 + RANDOM % 20)) # this run writes that row, and so is ready for a signal
  mpiexec -n $n "$frana" run scene.yaml --out stopped $resume >out 2>err & pid=$!
  if [ $stops -lt 3 ] && await $pid reached $target; then ranks_of $pid | xargs -r kill -TERM 2>/dev/null || true; fi
  wait $pid || got=$?
  if [ "$got" = 0 ] && [ $stops -lt 3 ]; then # it was done before the signal came: once more from the start
    rm -rf stopped
    stops=0 n=2 resume=
    continue
  fi
  [ "$got" = 0 ] && break
  [ "$got" = 75 ] || { cat out err >&2; fail "stopped with exit code $got"; }
  [ -f stopped/checkpoint/latest ] || fail "stopped without a checkpoint"
  stops=$((stops + 1)) n=$((n % $(by_day 2 3) + 1)) resume=--resume
done
echo "stopped $stops times"
same whole/series.csv stopped/series.csv
forces whole/reactions.csv stopped/reactions.csv
cut -d, -f1-8 whole/fragments.csv | diff - <(cut -d, -f1-8 stopped/fragments.csv) ||
  fail "other fragments after resuming"

# nothing to go on from: no folder is made
code 4 ranks 1 run scene.yaml --out nothing --resume
[ ! -e nothing ] || fail "a failed --resume has made a folder"

# another run starts from a stage's checkpoint
code 0 ranks "$(by_day 1 3)" run scene.yaml --out branch --resume=whole/checkpoint/stage_settle.h5
sed -n '1,2p' whole/series.csv >tail.csv && awk -F, 'NR > 2 && $1 > 120' whole/series.csv >>tail.csv
same tail.csv branch/series.csv
echo ok
