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
refuses 2 '--table=page: must be performance' --table=page
refuses 2 'of which measured tables' --table=growth
refuses 2 'takes files with --table only' some.csv
refuses 2 'goes with frana run, permeability and calibrate only' --quiet
refuses 2 '--set: goes with frana run, check, permeability and calibrate only' --set a=b
refuses 2 'unknown option' --fast
refuses 4 'missing.csv: cannot be opened' --table=growth missing.csv
printf 'part,size\nfluid_step\n' >broken.csv
refuses 4 'broken.csv: a row has not the 2 cells' --table=growth broken.csv
printf 'code,bonds\nLAMMPS,1\n' >lammps.csv
echo '{"status": "stopped", "wall_seconds": 3}' >run.json
printf 'part,size\nfluid_step,8x8x8\n' >rows.csv
refuses 4 'run.json: is not of a run that is done' --table=performance rows.csv run.json
mkdir other
cp run.json other
refuses 4 'run.json: is in none of the folders' --table=performance "$PWD/rows.csv" other/run.json
refuses 4 'none of the files in this folder holds measured times' --table=performance lammps.csv
touch file
refuses 4 'file/.*csv: cannot be written' --quick --only limits --out file
