#!/usr/bin/env bash
# Runs S1, S2, S3 as the thesis prescribes (thesis.yaml), the first two stages shortened, and the first 300 steps of
# fracture of s1.yaml to s3.yaml with both loads from the settled states of run.sh, with fields every 100 steps. Writes
# how they break (results/letter_*.csv), and what told it beforehand (results/criteria.csv).
# usage: cases/porous_channel/letter.sh [RANKS [RUNS [MAIN]]]     0 ranks: collects only
#   defaults: 2; runs/porous_channel_letter; runs/porous_channel, the runs of run.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
n=${1:-2} runs=${2:-runs/porous_channel_letter} main=${3:-runs/porous_channel} case=cases/porous_channel
out=$case/results
. cases/common.sh
go() { # go SET RUN ENERGY SCENE [OPTION ...]; a run that became unstable has ended itself and is kept
  [ "$n" = 0 ] || grep -qs '"status": *"\(done\|unstable\)"' "$runs/$1/$2/run.json" ||
    mpiexec -n "$n" build/frana run "$case/$4.yaml" --out "$runs/$1/$2" --set output.fields_every=100 \
      --set solid.materials.ceramic.fracture_energy="$3" "${@:5}" || [ $? = 3 ]
}
collect() { # collect SET BEFORE
  build/frana post "$runs/$1"/s{1,2,3} --before "$2" --out "$runs/$1/compared"
  cp "$runs/$1/compared/summary.csv" "$out/letter_$1.csv"
  for s in s1 s2 s3; do sed "1s/^/run,/; 2d; 2,\$s/^/$1 $s,/" "$runs/$1/$s/post/criteria.csv"; done >"$runs/$1/told"
}
for s in 1:0.05 2:0.03 3:0.02; do
  undamped=(--set=coupling.load=reaction --set=stages.{settle,fracture}.damping_relative=0)
  for load in reaction probe; do
    [ $load = reaction ] || undamped=()
    go $load "s${s%:*}" "${s#*:}" s1 --resume="$main/$load/s1/checkpoint/stage_settle.h5" \
      --set stages.fracture.steps=300 "${undamped[@]}"
  done
  from=(--resume="$runs/letter/s1/checkpoint/stage_settle.h5")
  [ $s != 1:0.05 ] || from=()
  go letter "s${s%:*}" "${s#*:}" thesis "${from[@]}" --set stages.flow.steps=300 --set stages.settle.steps=1000
done
go letter settled 0.05 thesis --resume="$runs/letter/s1/checkpoint/stage_settle.h5" --set stages.flow.steps=300 \
  --set stages.settle.steps=1000 --set stages.fracture.steps=1 --set stages.fracture.breakage=false \
  --set output.fields_every=1
build/frana post "$runs/letter/settled"
for load in reaction probe; do collect $load "$main/$load/s1"; done
collect letter "$runs/letter/s1"
cp "$runs/letter/settled/post/pictures/displacement_back.png" "$out/letter_settled_displacement.png"
cp "$runs/letter/s1/post/pictures/damage_section.png" "$out/letter_s1_damage_section.png"
awk 'NR == 1 || !/^run/' "$runs"/{letter,probe,reaction}/told >"$out/criteria.csv"
for s in 1 2 3; do # of a run that ended itself up to its last good state
  good=$(sed -n 's/step_0*\([0-9]*\).h5/\1/p' "$runs/letter/s$s/checkpoint/latest")
  awk -F, -v good="${good:-1e9}" 'NR < 3 || $1 + 0 <= good + 0' "$runs/letter/s$s/series.csv" \
    >"$out/series_letter_s$s.csv"
done
