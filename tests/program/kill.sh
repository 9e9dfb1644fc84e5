#!/usr/bin/env bash
# A run that is killed (SIGKILL) or stopped (SIGTERM or SIGINT, each once in four) at random times and resumed ends with
# the same series, and no finished file is ever damaged. After SIGKILL alone the series is the same to the bit; after a
# stop, whose checkpoint the uninterrupted run does not write, to round-off.
# usage: kill.sh FRANA SOURCE WORK LOOK KILLS [SEED]
# RANKS: number of ranks (default 2). A rank or mpiexec is hit: some time after the start, or while a checkpoint or a
# field is being written.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
look=$(realpath "$4") kills=$5 seed=${6:-$((EPOCHSECONDS % 32768))} until=$((EPOCHSECONDS + ${7:-86400}))
RANDOM=$seed n=${RANKS:-2}
echo "seed $seed"
scene | sed -e '/name: flow/s/steps: [0-9]*/steps: 30/; /name: settle/s/steps: [0-9]*/steps: 30/' \
  -e 's/series_every: .*/series_every: 5/; s/fields_every: .*/fields_every: 6/' \
  -e 's/checkpoint_every: .*/checkpoint_every: 4/' \
  -e 's/substeps: 4/substeps: auto/' >scene.yaml
code 0 ranks "$n" run scene.yaml --out whole
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "bonds_broken") b = i }
  END { exit !($b > 0) }' whole/series.csv ||
  fail "nothing has broken"
wall=$(grep -o '"wall_seconds": *[0-9.]*' whole/run.json | grep -o '[0-9.]*$')
echo "uninterrupted: $wall s"
half=$(awk -v w="$wall" 'BEGIN { h = int(500 * w); print h < 700 ? 700 : h }') # milliseconds

exists() { compgen -G "$1" >/dev/null; }
# random A B: a random time of A to B thousandths of a second, in seconds
random() { local ms=$(($1 + RANDOM % ($2 - $1))); printf '%d.%03d' $((ms / 1000)) $((ms % 1000)); }

# Leaves the processor to the run; a file is being written for longer than this.
wait_a_moment() { read -rt 0.0005 -u "$nothing" || true; }
# Waits for the time of the kill: a random time after the start, or the n-th file that is being written.
moment() {
  local part count
  case $1 in
  0) sleep "$(random 1 $((2 * half)))"; return ;;
  1) part='run/checkpoint/*.part' count=$((1 + RANDOM % 6)) ;;
  2) part='run/fields/*.part' count=$((1 + RANDOM % 6)) ;;
  3)
    until exists run/series.csv || ! kill -0 "$mpiexec" 2>/dev/null; do wait_a_moment; done
    sleep "$(random 1 "$half")"
    return
    ;;
  esac
  while ((count-- > 0)); do
    while exists "$part" && kill -0 "$mpiexec" 2>/dev/null; do wait_a_moment; done
    until exists "$part" || ! kill -0 "$mpiexec" 2>/dev/null; do wait_a_moment; done
  done
}

declare -A during=([set-up]=0 [step]=0 [checkpoint]=0 [field]=0 [record]=0) victims=([rank]=0 [mpiexec]=0)
killed=0 ends=0 waits=0 anew=0 stopped=0 soft=0
rm -rf run
while :; do
  resume=
  if exists 'run/checkpoint/*.h5'; then resume=--resume; elif [ -e run ]; then rm -rf run; anew=$((anew + 1)); fi
  [ "$resume" ] || soft=0
  got=0
  mpiexec -n "$n" "$frana" run scene.yaml --out run $resume >out 2>err & mpiexec=$!
  ((EPOCHSECONDS < until)) || kills=$killed
  if ((killed < kills)); then
    moment $((RANDOM % 4))
    # shellcheck disable=SC2207 # numbers
    pids=($(ranks_of "$mpiexec" || true))
    if ((${#pids[@]} == n && RANDOM % 3 > 0)); then
      victim=rank pid=${pids[RANDOM % n]}
    else
      victim=mpiexec pid=$mpiexec
    fi
    signals=(KILL KILL TERM INT) signal=${signals[RANDOM % 4]}
    if kill -$signal "$pid" 2>/dev/null; then hit=1; else hit=0; fi
    wait "$mpiexec" 2>/dev/null || got=$?
    for pid in "${pids[@]}"; do # what mpiexec has left behind goes by itself
      kill -0 "$pid" 2>/dev/null && echo "rank $pid lives on after a kill, and is waited for"
      while kill -0 "$pid" 2>/dev/null; do sleep 0.05; done
    done
  else
    hit=0
    wait "$mpiexec" || got=$?
  fi
  if [ "$got" = 4 ] && grep -q 'another run is at work' err; then waits=$((waits + 1)); sleep 0.1; continue; fi
  if [ "$got" = 0 ]; then # finished, or killed too late
    if ((soft)); then same whole/series.csv run/series.csv; else cmp whole/series.csv run/series.csv; fi
    exists 'run/*/*.part' && fail "an unfinished file is left: $(ls run/*/*.part)"
    ((soft)) || [ "$("$look" run | tail -n 1)" = "$("$look" whole | tail -n 1)" ] ||
      fail "other files than of the uninterrupted run"
    ends=$((ends + 1))
    ((killed < kills)) || break
    rm -rf run
    continue
  fi
  ((hit)) || { cat out err >&2; fail "ended with exit code $got without being killed"; }
  [ "$signal" = KILL ] || stopped=$((stopped + 1)) soft=1
  killed=$((killed + 1)) victims[$victim]=$((victims[$victim] + 1))
  if exists 'run/checkpoint/*.h5.part'; then what=checkpoint
  elif exists 'run/fields/*.part'; then what=field
  elif exists 'run/*.part' || exists 'run/checkpoint/latest.part'; then what=record
  elif [ ! -e run/series.csv ] ||
    { [ -z "$resume" ] && ! exists 'run/checkpoint/*.h5' && [ "$(wc -l <run/series.csv)" -le 2 ]; }; then what=set-up
  else what=step; fi
  during[$what]=$((during[$what] + 1))
  if [ -d run ]; then
    "$look" run >found || { cat found >&2; fail "damaged after kill $killed, of $victim, during $what"; }
  fi
done
echo "$killed kills (${victims[rank]} of a rank, ${victims[mpiexec]} of mpiexec; $stopped by SIGTERM or SIGINT):" \
  "${during[checkpoint]} during a checkpoint," \
  "${during[field]} a field, ${during[record]} latest or run.json, ${during[set-up]} set-up, ${during[step]} a step;" \
  "$anew begun anew, $waits waits for a folder in use, $ends runs done"
echo ok
