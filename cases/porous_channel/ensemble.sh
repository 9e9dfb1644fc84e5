#!/usr/bin/env bash
# Runs the first MEMBERS of the ten inflows of study_ensemble.yaml, for S1 to S3 with both loads, a rank each, and keeps
# their bands in results/: over time, ensemble.csv and .png, and at the end, ensemble_end.csv. Finished runs are kept.
# usage: cases/porous_channel/ensemble.sh [MEMBERS [RUNS]]  (10, runs/porous_channel_ensemble)  0 members: collects only
set -euo pipefail
cd "$(dirname "$0")/../.."
members=${1:-10} runs=${2:-runs/porous_channel_ensemble} case=cases/porous_channel frana=${FRANA:-build/frana}
out=$case/results
for n in $(seq $((6 * members))); do "$frana" study $case/study_ensemble.yaml --out "$runs" --run "$n"; done
awk -F, -v end="$out/ensemble_end.csv" -f $case/ensemble.awk "$runs"/runs/study_ensemble/*/all/*/series.csv \
  >"$out/ensemble.csv"
if command -v gnuplot >/dev/null; then gnuplot -e "folder = '$out'" $case/ensemble.gp; fi
