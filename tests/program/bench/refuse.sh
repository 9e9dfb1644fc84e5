#!/usr/bin/env bash
# Command lines that frana bench must refuse: one sentence, and exit code 2 (4 for a file).     usage: refuse.sh FRANA
# WORK
set -euo pipefail
frana=$(realpath "$1") work=$2
rm -rf "$work" && mkdir -p "$work" && cd "$work"
# refuses CODE SENTENCE options...
refuses() {
  local want=$1 sentence=$2 got=0
  shift 2
  "$frana" bench "$@" >out 2>err || got=$?
  [ $got = "$want" ] && [ "$(grep -c '^frana: ' err)" = 1 ] && grep -q -e "$sentence" err ||
    { echo "FAILED: frana bench $*: code $got, says:"; cat err; exit 1; } >&2
}
refuses 2 '--only fluids: must be of limits' --only limits,fluids
refuses 2 '--sizes 12x8: must be cells' --sizes 12x8
refuses 2 '--sizes 0: must be cells' --sizes 0
refuses 2 '--sizes 8x0x8: must be cells' --sizes 16x8x8,8x0x8
refuses 2 '--repeats 4: must be a whole number' --repeats 4
refuses 2 '--repeats 5x: must be a whole number' --repeats 5x
refuses 2 '--repeats 100000: must be 5 to' --repeats 100000
refuses 2 'bench some.csv: takes no arguments' some.csv
refuses 2 'goes with frana run, permeability and calibrate only' --quiet
refuses 2 '--set: goes with frana run, check, permeability and calibrate only' --set a=b
refuses 2 'unknown option' --fast
touch file
refuses 4 'file/.*csv: cannot be written' --quick --only limits --out file
