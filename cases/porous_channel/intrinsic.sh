#!/usr/bin/env bash
# What the intrinsic permeability of every hundredth step costs in S2 and S3: 600 steps from the settled state of S1, in
# which most bonds break, and 600 late ones. It needs the runs of run.sh. On RANKS ranks, 2 if it is not set.
# usage: cases/porous_channel/intrinsic.sh [FRANA [RUNS [OUT]]]   writes OUT/intrinsic.csv
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
frana=$(realpath "${1:-build/frana}") runs=$(realpath "${2:-runs/porous_channel/reaction}")
out=$(realpath "${3:-$here/results}")
one() { # one SCENE FROM STEPS CHECKPOINT
  local share run="$runs/intrinsic_$1_$2" && rm -rf "$run"
  mpiexec -n "${RANKS:-2}" "$frana" run "$runs/$1/scene.resolved.yaml" --resume="$4" --out "$run" --quiet \
    --set output.permeability_every=100 --set "stages.fracture.steps=$3" --set output.fields_every=0 \
    --set output.checkpoint_every=0 --set output.series_every=100 >"$run.log" 2>&1 || { cat "$run.log" >&2; exit 1; }
  share=$(sed -n 's/.*solutions, .* s, \(.*\) % of the run.*/\1/p' "$run/run.log" | tail -1)
  awk -F, -v name="$1,$2" -v share="$share" '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 { printf "%s,%d,%.6g,%.6g,%.6g,%.2g,%d,%d,%d,%s\n", name, $at["step"], $at["k_xx"], $at["k_yy"], $at["k_zz"],
      $at["error"], $at["solved"], $at["iterations"], $at["products"], share }' "$run/intrinsic.csv"
}
{
  echo "scene,from,step,k_xx,k_yy,k_zz,error,solved,iterations,products,percent of the run's time"
  for s in s2 s3; do
    one $s settled 600 "$runs/s1/checkpoint/stage_settle.h5"
    one $s late 4600 "$runs/$s/checkpoint/step_00014000.h5"
  done
} >"$out/intrinsic.new"
mv "$out/intrinsic.new" "$out/intrinsic.csv"
