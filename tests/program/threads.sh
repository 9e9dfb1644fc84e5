#!/usr/bin/env bash
# A coupled run whose bonds break is the same on several threads and ranks; so is one whose ranks have uneven pieces. A
# plate that breaks is the same to the bit on any number of threads.
# What threads a command takes.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# shellcheck source=tests/program/scenes.sh
. "$source/tests/program/scenes.sh"
export OMP_WAIT_POLICY=passive # there may be more threads than cores
scene >scene.yaml
code 0 ranks 1 run scene.yaml --out one
for threads in 2 3; do
  code 0 ranks 1 run scene.yaml --out threads-$threads --threads $threads
  same one/series.csv threads-$threads/series.csv
  grep -q "\"threads\": $threads" threads-$threads/run.json || fail "run.json does not tell of $threads threads"
done
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "bonds_broken") k = i } END { exit !($k > 100) }' \
  one/series.csv || fail "too few bonds break"
code 0 ranks 2 run scene.yaml --out ranks --threads 2
same one/series.csv ranks/series.csv
# the block in one half of a channel twice as wide: the pieces of z are cut by work (tests/coupling/setup/test_share.c)
sed -e 's/size: .*/size: [0.05, 0.025, 0.05]/' -e 's/cells: .*/cells: [32, 16, 32]/' -e 's/steps: 60/steps: 30/' \
  scene.yaml >wide.yaml
code 0 ranks 1 run wide.yaml --out wide-1
code 0 ranks "$(by_day 2 3)" run wide.yaml --out wide-3
same wide-1/series.csv wide-3/series.csv
torn_plate 0 0.008 'integrator: verlet, damping_relative: 1.0e14' | sed 's/every: 10/every: 2/' >plate.yaml
code 0 ranks 1 run plate.yaml --out plate-1
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  END { exit !($at["e_fracture"] > 0 && $at["e_damped"] > 0) }' plate-1/series.csv || fail "the plate is not torn"
for threads in 2 3 7; do
  code 0 ranks 1 run plate.yaml --out plate-$threads --threads $threads
  cmp plate-1/series.csv plate-$threads/series.csv || fail "a plate depends on the number of threads"
done
# with another Poisson's ratio, whose pressures are exchanged between two passes
ratio='solid.materials[0].poisson_ratio=0.2'
code 0 ranks 1 run plate.yaml --set "$ratio" --out ratio-1
code 0 ranks 1 run plate.yaml --set "$ratio" --out ratio-3 --threads 3
cmp ratio-1/series.csv ratio-3/series.csv || fail "a plate of another ratio depends on the number of threads"
! cmp -s ratio-1/series.csv plate-1/series.csv || fail "the ratio changes nothing"
code 2 ranks 1 run scene.yaml --out none --threads 0
grep -q 'threads 0: must be a whole number, at least 1' err || fail "0 threads: $(cat err)"
code 2 ranks 1 run scene.yaml --out none --threads 1000
grep -q 'at most 256' err || fail "1000 threads: $(cat err)"
code 2 ranks 1 post one --threads 2
grep -q 'goes with frana run' err || fail "post takes threads: $(cat err)"
[ ! -e none ] || fail "a refused run left a folder"
echo ok
