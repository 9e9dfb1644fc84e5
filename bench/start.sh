#!/usr/bin/env bash
# Seconds of start and end of runs, by phase, and of files and samples (docs/timeline.md).
#     bench/start.sh [--frana PROGRAM] [--repeats N] [--ranks "1 2"] [--scenes "demo S3 plate"]
# Each scene takes a few steps a stage. `first`: the user's cache, a folder of its own, has FFTW's wisdom but not the
# rates of the solid's stable step. `again`: it has both. Numbers are medians over the repeats. `to the prompt` is
# the time from the last step to the end of mpiexec. Nothing else should run on the machine.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
frana=$root/build/frana repeats=5 ranks="1 2" scenes="demo S3 plate"
fail() { echo "start.sh: $*" >&2; exit 2; }
while [ $# -gt 0 ]; do
  case $1 in
    --frana | --repeats | --ranks | --scenes)
      [ $# -gt 1 ] || fail "$1 needs a value"; printf -v "${1#--}" %s "$2"; shift 2 ;;
    *) fail "$1: unknown option; there are --frana, --repeats, --ranks and --scenes" ;;
  esac
done
[[ $repeats =~ ^[1-9][0-9]*$ ]] || fail "--repeats $repeats: must be a whole number, at least 1"
for n in $ranks; do [[ $n =~ ^[1-9][0-9]*$ ]] || fail "--ranks $n: must be whole numbers, at least 1"; done
for scene in $scenes; do
  case $scene in demo | S3 | plate) ;; *) fail "--scenes $scene: must be of demo, S3 and plate" ;; esac
done
[ -x "$frana" ] || fail "$frana: there is no such program; build it, or name it with --frana"
frana=$(realpath "$frana")
if [ "$(id -u)" = 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
export OMPI_MCA_hwloc_base_binding_policy=none
unset OMPI_MCA_mpi_yield_when_idle
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export XDG_CACHE_HOME=$work/cache
mkdir "$XDG_CACHE_HOME"
phases="launch scene fluid plans solid bonds surface forcing limits output"

# run SCENE RANKS WHEN: a run in $work/run; its numbers, one a line, go to the files $work/SCENE.RANKS.WHEN.*
run() {
  local of=$work/$1.$2.$3 file=$root/bench/start_plate.yaml ended sets=() stage
  case $1 in demo) file=$root/cases/porous_channel/demo.yaml ;; S3) file=$root/cases/porous_channel/s3.yaml ;; esac
  if [ "$1" != plate ]; then # each stage ends with a sample, a file of fields and a checkpoint, and has no other
    for stage in flow settle fracture; do sets+=(--set "stages.$stage.steps=4"); done
  fi
  rm -rf "$work/run"
  mpiexec -n "$2" "$frana" run "$file" --out "$work/run" ${sets[@]+"${sets[@]}"} >"$work/log" 2>&1 ||
    { tail -n 3 "$work/log" >&2; fail "$1 failed on $2 ranks"; }
  ended=$(date +%s.%N)
  [ "$3" != warm ] || return 0
  awk -v of="$of" -v ended="$ended" -v written="$(stat -c %.Y "$work/run/run.json")" -v phases="$phases" '
    function number(line) { sub(/^[^:]*: */, "", line); return line + 0 }
    /"end_seconds"/ { end = number($0) }
    /"setup_seconds_by_phase"/ { inside = 1; next }
    inside && /}/ { inside = 0 }
    inside { split($0, word, "\""); second[word[2]] = number($0) }
    /"span"/ { split($0, word, "\""); span = word[4] }
    /"details"/ { details = 1 }
    details && /}/ { details = 0 }
    details && span ~ /^(flow|settle|fracture)$/ && /"(series|fields|checkpoint)"/ {
      split($0, word, "\"")
      print 1e3 * number($0) >>(of "." span "." word[2]) }
    END {
      n = split(phases, name, " ")
      for (k = 1; k <= n; k++) {
        if (!(name[k] in second)) { print "no phase " name[k] >"/dev/stderr"; exit 1 }
        sum += second[name[k]]
        print second[name[k]] >>(of "." name[k]) }
      print sum >>(of ".sum")
      print sum - second["launch"] - second["solid"] - second["bonds"] - second["surface"] - second["limits"] \
        >>(of ".rest")
      print end + ended - written >>(of ".prompt") }' "$work/run/run.json"
}
# middle FORMAT FILE: the median of the numbers in a file
middle() {
  sort -g "$2" |
    awk -v f="$1" '{ v[NR] = $1 } END { printf f, (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'
}

echo "| scene | ranks | launch | solid | bonds | surface | limits, first | limits, again | rest |" \
  "to the first step, first | again | to the prompt |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|"
for n in $ranks; do
  for scene in $scenes; do
    run "$scene" "$n" warm
    for ((k = 1; k <= repeats; k++)); do
      rm -f "$XDG_CACHE_HOME/frana/rates.txt"
      run "$scene" "$n" first
      run "$scene" "$n" again
    done
    line="| $scene | $n |"
    for what in again.launch again.solid again.bonds again.surface first.limits again.limits again.rest first.sum \
      again.sum again.prompt; do
      line+=" $(middle %.2f "$work/$scene.$n.$what") |"
    done
    echo "$line"
  done
done
for n in $ranks; do
  [ -f "$work/S3.$n.again.flow.series" ] || continue
  printf '\nS3, %s ranks, ms of working:\n\n' "$n"
  printf '%s\n' "| stage | fields | checkpoint | sample, and tables at the end of a stage |" "|---|---|---|---|"
  for stage in flow settle fracture; do
    line="| $stage |"
    for what in fields checkpoint series; do line+=" $(middle %.0f "$work/S3.$n.again.$stage.$what") |"; done
    echo "$line"
  done
done
