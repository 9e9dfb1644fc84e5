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

echo
awk -f tools/summary.awk runs/demo/post/summary.csv
echo
say "run: runs/demo (series.csv, fields/*.hdf.series for ParaView, run.json)"
find runs/demo/post -name '*.png' -o -name '*.svg' -o -name '*.html' -o -name '*.md' | sort | sed 's/^/   /'
