#!/usr/bin/env bash
# Load on each sphere of a random pack, by each way to find the load.
# usage: cases/verification/pack/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
[ ! "$quick" ] || { [ "$again" ] || "$frana" check "$here/scene.yaml" >/dev/null; exit; }
study study
study study_probes
whole=0.80607453 # 1 - c, ten spheres of radius 1/6 in 1 m3
for cells in 8 12; do
  near "$cells cells a radius: forcing over driving" 1 "$(cell study value reaction $cells forcing)" 1 \
    "balance of forces" 1e-3
  near "$cells cells a radius: load on all spheres by reaction, over driving" 1 \
    "$(cell study value reaction $cells all)" $whole "the driving of the outer fluid" 0.02
done
for load in wall probe; do
  near "8 cells a radius: load on all spheres by $load, over driving" 1 "$(cell study_probes value $load 8 all)" \
    $whole "the driving of the outer fluid" 0.02
done
for sphere in 1 2 3 4 5 6 7 8 9 10; do
  fine=$(cell study value reaction 12 "sphere $sphere")
  near "8 cells a radius: load on sphere $sphere by reaction, over driving" 1 \
    "$(cell study value reaction 8 "sphere $sphere")" "$fine" "reaction, 12 cells a radius" 0.02
done
for load in wall probe; do
  for sphere in 1 2 3 4 5 6 7 8 9 10; do
    shown "8 cells a radius: load on sphere $sphere by $load, over that by reaction at 12" 1 \
      "$(calc "$(cell study_probes value $load 8 "sphere $sphere") / $(
        cell study value reaction 12 "sphere $sphere")")" 1 "reaction, 12 cells a radius"
  done
done
finish
