#!/usr/bin/env bash
# Installs what is missing, builds, and breaks a porous block in a channel: the small twin of the main case
# (cases/porous_channel), on two ranks, into runs/demo; then its numbers and pictures. Any further arguments go to
# frana run, e.g. ./demo.sh --set output.fields_every=10
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

setup_install
setup_build build
setup_mpi 2

rm -rf runs/demo
say "running cases/porous_channel/demo.yaml on 2 ranks into runs/demo"
mpiexec -n 2 build/frana run cases/porous_channel/demo.yaml --out runs/demo "$@"
say "measuring and drawing: frana post runs/demo"
build/frana post runs/demo

echo
grep -v '^#' runs/demo/post/summary.csv | awk -F ', *' '
    NR == 1 { for (c = 1; c <= NF; c++) { if ($c == "quantity") q = c; if ($c == "unit") u = c; if ($c == "value") v = c }; next }
    { printf "  %-36s %16s  %s\n", $q, $v, $u == "1" ? "" : $u }'
echo
say "run: runs/demo (series.csv, fields/*.hdf.series for ParaView, run.json)"
find runs/demo/post -name '*.png' -o -name '*.svg' -o -name '*.html' -o -name '*.md' | sort | sed 's/^/   /'
