#!/usr/bin/env bash
# Installs missing packages, builds, and runs a porous block that breaks in a channel, the small version of the main
# case (cases/porous_channel), on two ranks, in runs/demo; then makes its numbers and pictures. Further arguments are
# passed to frana run, e.g. ./demo.sh --set output.fields_every=10
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

setup_install
FRANA_TARGET=${FRANA_TARGET:-frana} setup_build build # the program, without its tests
setup_mpi 2

rm -rf runs/demo
say "running cases/porous_channel/demo.yaml on 2 ranks into runs/demo"
mpiexec -n 2 build/frana run cases/porous_channel/demo.yaml --out runs/demo "$@"
say "measuring and drawing: frana post runs/demo"
build/frana post runs/demo


# The names of the pictures in a folder of runs/demo/post.
pictures() {
    find "runs/demo/post/$1" -name '*.png' -printf '%f\n' | sort | sed 's/\.png$//' | paste -sd ' ' | fold -sw 100 |
        sed 's/^/      /'
}
chosen='status|dp, before|dp, after|porosity, before|porosity, after|permeability, before|permeability, after'
chosen+='|load on the solid, x, before|load on the solid, x, after|bonds broken|bonds broken, share|fragments'
chosen+='|largest fragment|first bond broken, t|where it broke first|mass of the pieces that came off, share'
chosen+='|ranks|steps|wall time'
say "what happened; before: the flow has settled around the unbroken block, after: the end"
awk -v only="$chosen" -f tools/summary.awk runs/demo/post/summary.csv
say "where it is"
cat <<'END'
   runs/demo/post/report.html             all numbers, plots and pictures on one page, for a browser
   runs/demo/post/summary.csv             all numbers
   runs/demo/series.csv                   what was measured, against time
   runs/demo/fields/*.hdf.series          flow and solid, for ParaView
   runs/demo/post/pictures/*.png, *.svg
END
pictures pictures
echo "   runs/demo/post/plots/*.png, *.svg"
pictures plots
