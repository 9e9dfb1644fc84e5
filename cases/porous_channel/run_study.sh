#!/usr/bin/env bash
# Measures in short runs of S2 of the main case what each choice changes and costs, and how far round-off makes its runs
# differ. Finished runs are kept. Takes about 30 minutes on two cores. Nothing else should run on the machine.
# usage: cases/porous_channel/run_study.sh [FRANA [RUNS [SETTLED]]]      (build/frana, runs/porous_channel_study,
#   runs/porous_channel/probe/s1/checkpoint/stage_settle.h5, which is made if it is missing)
set -euo pipefail
cd "$(dirname "$0")/../.."
frana=$(realpath "${1:-build/frana}") runs=${2:-runs/porous_channel_study} case=cases/porous_channel \
  out=cases/porous_channel/results
settled=${3:-runs/porous_channel/probe/s1/checkpoint/stage_settle.h5}
. cases/common.sh && mkdir -p "$runs" "$out"
for study in iterations surface choices grid step reaction loads softening; do
  "$frana" study "$case/study_$study.yaml" --out "$runs"
  cp "$runs/study_$study".csv "$runs/study_$study"_pressure-drop.png "$out"
  sed '/^!\[.*\.png)$/{/_pressure-drop\.png)$/!d;}' "$runs/study_$study".md | cat -s >"$out/study_$study.md"
done
for study in ratio horizon; do "$frana" study "$case/study_$study.yaml" --out "$runs"; done
awk -F, -f $case/study_horizon.awk "$runs"/runs/study_horizon/*/*/1/{intrinsic,series}.csv >"$out/horizon.csv"
cp "$runs/study_ratio.csv" "$out" && sed '/^!\[/d' "$runs/study_ratio.md" | cat -s >"$out/study_ratio.md"

go() { # go FOLDER SCENE [...]: does nothing for a finished run
  local folder=$1 scene=$2 && shift 2
  is_done "$folder" && return
  rm -rf "$folder"
  mpiexec -n 2 "$frana" run "$case/$scene" --out "$folder" --quiet --set output.fields_every=0 \
    --set output.checkpoint_every=0 "$@"
}
if [ ! -f "$settled" ]; then
  settled=$runs/settled/checkpoint/stage_settle.h5
  go "$runs/settled" s1.yaml --set stages.fracture.steps=0
fi
members=()
for change in 0 1e-12 1e-6 1e-4; do
  inflow=$(awk -v e=$change 'BEGIN { printf "%.16g", 0.1 * (1 + e) }')
  go "$runs/chaos/$change" s2.yaml --resume="$settled" --set stages.fracture.steps=200 --set output.series_every=1 \
    --set "fluid.sides.x_low.bulk_velocity=$inflow"
  members+=("$runs/chaos/$change/series.csv")
done
awk -f "$case/study_chaos.awk" "${members[@]}" >"$out/study_chaos.csv"
if command -v gnuplot >/dev/null; then gnuplot -e "folder = '$out'" "$case/study_chaos.gp"; fi
