#!/usr/bin/env bash
# Runs the three scenes at full size, from the stages that they share, and writes results/.
# usage: cases/porous_channel/run.sh [RANKS] [RUNS]      (2, runs/porous_channel)
#        cases/porous_channel/run.sh --summary     runs nothing: judges the series in results/ again
set -euo pipefail
cd "$(dirname "$0")/../.."
[ "${1-}" != --summary ] || exec cases/porous_channel/collect.sh --summary
n=${1:-2} runs=${2:-runs/porous_channel} case=cases/porous_channel frana=build/frana
. cases/common.sh
mkdir -p "$runs"
go() { # go NAME [--resume...]: resumes a run that was stopped; does nothing for a finished run
  local name=$1; shift
  is_done "$runs/$name" && return
  if [ -f "$runs/$name/checkpoint/latest" ]; then set -- --resume; else rm -rf "${runs:?}/$name"; fi
  mpiexec -n "$n" "$frana" run "$case/$name.yaml" --out "$runs/$name" "$@"
}
go s1
go s2 --resume="$runs/s1/checkpoint/stage_settle.h5"
go s3 --resume="$runs/s1/checkpoint/stage_settle.h5"
"$frana" post "$runs/s1" "$runs/s2" "$runs/s3" --out "$runs/compared"
"$case/collect.sh" "$runs"
