#!/usr/bin/env bash
# Runs S1, S2, S3 as the thesis prescribes (thesis.yaml), and as s1.yaml to s3.yaml with both loads, the first two
# stages shortened. Writes how they break (results/letter_*.csv), and what told it beforehand (results/criteria.csv).
# usage: cases/porous_channel/letter.sh [RANKS [RUNS]]   (2, runs/porous_channel_letter)     0 ranks: collects only
set -euo pipefail
cd "$(dirname "$0")/../.."
n=${1:-2} runs=${2:-runs/porous_channel_letter} case=cases/porous_channel out=cases/porous_channel/results
. cases/common.sh
reaction=(--set coupling.load=reaction --set stages.settle.damping_relative=0 --set stages.fracture.damping_relative=0)
while read -r set scene steps; do
  [ "$set" = reaction ] || reaction=()
  for s in 1:0.05 2:0.03 3:0.02; do
    to=$runs/$set/s${s%:*} from=(--resume="$runs/$set/s1/checkpoint/stage_settle.h5")
    [ $s != 1:0.05 ] || from=()
    [ "$n" = 0 ] || is_done "$to" || mpiexec -n "$n" build/frana run "$case/$scene.yaml" --out "$to" "${from[@]}" \
      --set stages.flow.steps=300 --set stages.settle.steps=1000 --set stages.fracture.steps="$steps" \
      --set output.fields_every=100 --set solid.materials.ceramic.fracture_energy="${s#*:}" "${reaction[@]}"
  done
  build/frana post "$runs/$set"/s{1,2,3} --before "$runs/$set/s1" --out "$runs/$set/compared"
  cp "$runs/$set/compared/summary.csv" "$out/letter_$set.csv"
  for s in 1 2 3; do
    sed "1s/^/run,/; 2d; 2,\$s/^/$set s$s,/" "$runs/$set/s$s/post/criteria.csv"
  done >"$runs/$set/told"
done <<<$'reaction s1 300\nprobe s1 300\nletter thesis 5000'
awk 'NR == 1 || !/^run/' "$runs"/{letter,probe,reaction}/told >"$out/criteria.csv"
for s in 1 2 3; do cp "$runs/letter/s$s/series.csv" "$out/series_letter_s$s.csv"; done
