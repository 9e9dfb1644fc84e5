#!/usr/bin/env bash
# docs/run-folder.md names every column of the series, with its unit.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
scenes=$source/tests/scene/scenes
code 0 ranks 1 run "$scenes/coupled.yaml" --out coupled --set stages.flow.steps=1 --set stages.settle.steps=1 \
  --set stages.fracture.steps=0
code 0 ranks 1 run "$scenes/plate.yaml" --out plate --set stages.pull.steps=1
code 0 ranks 1 run "$scenes/crack_fluid.yaml" --out cracks --set stages.pump.steps=1
for run in coupled plate cracks; do
  paste -d' ' <(sed -n 1p $run/series.csv | tr , '\n') <(sed -n '2s/^#//p' $run/series.csv | tr , '\n')
done | sort -u >columns
[ "$(wc -l <columns)" -gt 30 ] || fail "only $(wc -l <columns) columns"
while read -r name unit; do
  sed -n '/^## series.csv/,/^## crack.csv/p' "$source/docs/run-folder.md" | grep -F "\`$name\`" |
    grep -qF "| $unit |" ||
    fail "docs/run-folder.md lacks the column $name, $unit"
done <columns
