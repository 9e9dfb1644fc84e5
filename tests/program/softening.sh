#!/usr/bin/env bash
# A run in which bonds soften gives the same series on other ranks, and resumed in the middle on another number of
# ranks.
# (The series are compared to 1e-10: sums over ranks differ in the last digits.)
# usage: softening.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
broke() { # broke FILE: bonds have broken and softened by the end, and half way too
  awk -F, -v a="$1" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 && $1 == 60 { half = $at["e_fracture"] }
    END { exit !(half > 0 && $at["e_fracture"] > half && $at["bonds_broken"] > 0) }' "$1" ||
    fail "$1: nothing has softened and broken"
}
three=$(by_day 1 3)
other=$three resumed=1 # of the strip; the slab has them exchanged
for kind in strip slab; do
  sed -e '/name: run/s/steps: [0-9]*/steps: 120/; /name: run/s/damping_absolute: [0-9.]*/damping_absolute: 0.02/' \
    -e 's/checkpoint_every: .*/checkpoint_every: 60/' \
    "$source/cases/verification/softening/$kind.yaml" >$kind.yaml
  code 0 ranks 2 run $kind.yaml --out $kind
  broke $kind/series.csv
  code 0 ranks $other run $kind.yaml --out ${kind}_$other
  same $kind/series.csv ${kind}_$other/series.csv
  code 0 ranks $resumed run $kind.yaml --out ${kind}_again --resume=$kind/checkpoint/step_00000060.h5
  sed -n '1,2p' $kind/series.csv >tail.csv && awk -F, 'NR > 2 && $1 > 60' $kind/series.csv >>tail.csv
  same tail.csv ${kind}_again/series.csv
  other=1 resumed=$three
done
echo ok
