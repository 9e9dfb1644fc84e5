#!/usr/bin/env bash
# Measures, and writes the pages: bench/results/*.csv, docs/performance.md, the tables in docs/scaling.md.
#     bench/run.sh [--build DIR] [--no-lammps] [--cans DIR] [RUN.json...]
# --cans DIR: where a built CaNS is (bench/cans/run.sh), by its whole path; without it CaNS is left out.
# RUN.json: run.json of whole runs of the main case's S3, each with its scene.resolved.yaml in the same folder. Without
# one: those in bench/results.
# Builds the program if it is missing. Takes less than ten minutes. Nothing else should run on the machine.
set -euo pipefail
cd "$(dirname "$0")/.."
build=build lammps=1 cans='' runs=()
while [ $# -gt 0 ]; do
  case $1 in
    --build) [ $# -gt 1 ] || { echo "run.sh: --build needs a value" >&2; exit 2; }; build=$2; shift 2 ;;
    --no-lammps) lammps=; shift ;;
    --cans) [ $# -gt 1 ] || { echo "run.sh: --cans needs a value" >&2; exit 2; }; cans=$2; shift 2 ;;
    *.json) runs+=("$1"); shift ;;
    *) echo "run.sh: $1: unknown; there are --build DIR, --no-lammps, --cans DIR and run.json files" >&2; exit 2 ;;
  esac
done
[ ${#runs[@]} -gt 0 ] || runs=(bench/results/*/run.json)
if [ "$(id -u)" = 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
export OMPI_MCA_hwloc_base_binding_policy=none
unset OMPI_MCA_mpi_yield_when_idle
[ -f "$build/build.ninja" ] || [ -f "$build/Makefile" ] || cmake -S . -B "$build" >/dev/null
cmake --build "$build" --target frana >/dev/null
frana=$build/frana
rm -f bench/results/*.csv
for n in 1 2; do mpiexec -n $n "$frana" bench --out bench/results; done
if [ -n "$lammps" ] && command -v lmp >/dev/null; then
  bench/lammps/run.sh --frana "$frana" --out bench/results
elif [ -n "$lammps" ]; then
  echo "LAMMPS is missing (apt-get install lammps): left out"
fi
if [ -n "$cans" ]; then
  bench/cans/run.sh --frana "$frana" --cans "$cans" --out bench/results
else
  echo "no built CaNS is named (--cans DIR): left out"
fi
"$frana" bench --table=performance bench/results/*.csv bench/reference/*.csv "${runs[@]}" >docs/performance.md.part
mv docs/performance.md.part docs/performance.md
"$frana" bench --table=growth bench/results/*.csv >docs/scaling.md.table
awk -v table=docs/scaling.md.table '
  /^<!-- measured -->/ { print; print ""; while ((getline line < table) > 0) print line; inside = 1; next }
  /^<!-- end -->/ { inside = 0 }
  !inside' docs/scaling.md >docs/scaling.md.part
mv docs/scaling.md.part docs/scaling.md
rm docs/scaling.md.table
echo "docs/performance.md and docs/scaling.md are made of bench/results"
