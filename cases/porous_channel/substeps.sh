#!/usr/bin/env bash
# Shows whether the number of substeps matters: runs the first 250 steps of fracture of S1, S2 and S3 from one settled
# state, with the automatic number and with 6, 10 and 20. Writes results/substeps.csv. Finished runs are kept.
# usage: cases/porous_channel/substeps.sh SETTLED [RANKS] [RUNS]      SETTLED: a stage_settle.h5; (2, runs/substeps)
set -euo pipefail
settled=$(realpath "${1:?the checkpoint of a settled state: runs/porous_channel/probe/s1/checkpoint/stage_settle.h5}")
cd "$(dirname "$0")/../.."
n=${2:-2} runs=${3:-runs/substeps} case=cases/porous_channel table=cases/porous_channel/results/substeps.csv
. cases/common.sh && mkdir -p "$runs"
echo "run, substeps, at the end, dp, bonds_broken, fragments, porosity, permeability" >"$table"
for s in s1 s2 s3; do
  for substeps in auto 6 10 20; do
    run=$runs/${s}_$substeps
    set -- --set stages.fracture.steps=250 --set output.fields_every=0
    [ $substeps = auto ] || set -- "$@" --set "stages.fracture.substeps=$substeps"
    is_done "$run" || mpiexec -n "$n" build/frana run "$case/$s.yaml" --out "$run" --resume="$settled" "$@"
    last=$(number "$run/run.json" substeps)
    awk -F, -v run="$s" -v substeps="$substeps" -v last="$last" '
      NR == 1 { for (i = 1; i <= NF; i++) c[$i] = i }
      END { print run ", " substeps ", " last ", " $c["dp"] ", " $c["bonds_broken"] ", " $c["fragments"] \
        ", " $c["porosity"] ", " $c["permeability"] }' "$run/series.csv" >>"$table"
  done
done
cat "$table"
