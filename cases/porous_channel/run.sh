#!/usr/bin/env bash
# Runs the three scenes at full size with the thesis's probe and with the default load, each from the stages that they
# share, and writes results/. Runs that were stopped are resumed, finished ones are kept.
# usage: cases/porous_channel/run.sh [RANKS] [RUNS]      (2, runs/porous_channel)
#        cases/porous_channel/run.sh --summary     runs nothing: judges the series in results/ again
set -euo pipefail
cd "$(dirname "$0")/../.."
[ "${1-}" != --summary ] ||
  exec build/frana study cases/porous_channel/gates.yaml --out cases/porous_channel/results
n=${1:-2} runs=${2:-runs/porous_channel} case=cases/porous_channel frana=build/frana
. cases/common.sh
# The load by reaction, frana's default, needs no damping of the bonds.
undamped=(--set coupling.load=reaction --set stages.settle.damping_relative=0 --set stages.fracture.damping_relative=0)
go() { # go LOAD SCENE [--resume=...]; settled: the state before fracture, for its pictures
  local load=$1 scene=${2/settled/s1} folder=$runs/$1/$2
  shift 2
  is_done "$folder" && return
  if [ -f "$folder/checkpoint/latest" ]; then set -- --resume; else rm -rf "${folder:?}"; fi
  [ "$load" = probe ] || set -- "$@" "${undamped[@]}"
  mpiexec -n "$n" "$frana" run "$case/$scene.yaml" --out "$folder" "$@"
}
for load in probe reaction; do
  mkdir -p "$runs/$load"
  go $load s1
  go $load s2 --resume="$runs/$load/s1/checkpoint/stage_settle.h5"
  go $load s3 --resume="$runs/$load/s1/checkpoint/stage_settle.h5"
  go $load settled --resume="$runs/$load/s1/checkpoint/stage_settle.h5" --set stages.fracture.steps=1 \
    --set stages.fracture.breakage=false --set output.fields_every=1
  "$frana" post "$runs/$load/settled"
  "$frana" post "$runs/$load"/s{1,2,3} --before "$runs/$load/s1" --out "$runs/$load/compared"
done
"$case/collect.sh" "$runs"
