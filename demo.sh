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
# quantity,unit,value; a quantity that contains a comma is in quotes
awk '
    function field(   f) {
        if (substr($0, 1, 1) == "\"") {
            f = substr($0, 2)
            $0 = substr(f, index(f, "\"") + 2)
            return substr(f, 1, index(f, "\"") - 1)
        }
        f = index($0, ",") ? substr($0, 1, index($0, ",") - 1) : $0
        $0 = index($0, ",") ? substr($0, index($0, ",") + 1) : ""
        return f
    }
    /^#/ || NR == 1 { next }
    { q = field(); u = field(); v = field()
      if (v ~ /^[-+0-9.eE]+$/) v = sprintf("%.5g", v)
      if (u == "1") u = ""
      printf "  %-52s %16s  %s\n", q, v, u }' runs/demo/post/summary.csv
echo
say "run: runs/demo (series.csv, fields/*.hdf.series for ParaView, run.json)"
find runs/demo/post -name '*.png' -o -name '*.svg' -o -name '*.html' -o -name '*.md' | sort | sed 's/^/   /'
