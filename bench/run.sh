#!/usr/bin/env bash
# Measures this machine, and writes the table of docs/performance.md, a column for each folder of bench/results, and
# those of docs/scaling.md.
#     bench/run.sh [--machine NAME] [--build DIR] [--no-lammps] [--cans DIR] [RUN...]
# --machine NAME: the folder of bench/results, and the column's heading; this_machine unless given.
# --cans DIR: where a built CaNS is (bench/cans/run.sh), by its whole path; without it CaNS is left out.
# RUN: folders of whole runs of the main case's S3, by both integrators or by economical.sh. Their run.json and
# scene.resolved.yaml are copied into the machine's folder.
# Builds the program if it is missing. Takes less than ten minutes. Nothing else should run on the machine.
set -euo pipefail
cd "$(dirname "$0")/.."
machine=this_machine build=build lammps=1 cans='' runs=()
while [ $# -gt 0 ]; do
  case $1 in
    --machine) [ $# -gt 1 ] || { echo "run.sh: --machine needs a value" >&2; exit 2; }; machine=$2; shift 2 ;;
    --build) [ $# -gt 1 ] || { echo "run.sh: --build needs a value" >&2; exit 2; }; build=$2; shift 2 ;;
    --no-lammps) lammps=; shift ;;
    --cans) [ $# -gt 1 ] || { echo "run.sh: --cans needs a value" >&2; exit 2; }; cans=$2; shift 2 ;;
    *)
      [ -f "$1/run.json" ] ||
        { echo "run.sh: $1: no run; there are --machine, --build, --no-lammps, --cans and runs" >&2; exit 2; }
      runs+=("$(realpath "$1")"); shift ;;
  esac
done
if [ "$(id -u)" = 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
export OMPI_MCA_hwloc_base_binding_policy=none
unset OMPI_MCA_mpi_yield_when_idle
[ -f "$build/build.ninja" ] || [ -f "$build/Makefile" ] || cmake -S . -B "$build" >/dev/null
cmake --build "$build" --target frana >/dev/null
frana=$build/frana
results=bench/results/$machine
mkdir -p "$results"
rm -f "$results"/*-[12]*.csv
for n in 1 2; do mpiexec -n $n "$frana" bench --out "$results"; done
for run in "${runs[@]}"; do
  mkdir -p "$results/$(basename "$run")"
  cp "$run"/run.json "$run"/scene.resolved.yaml "$results/$(basename "$run")"
done
if [ -n "$lammps" ] && command -v lmp >/dev/null; then
  bench/lammps/run.sh --frana "$frana" --out "$results"
elif [ -n "$lammps" ]; then
  echo "LAMMPS is missing (apt-get install lammps): left out"
fi
if [ -n "$cans" ]; then
  bench/cans/run.sh --frana "$frana" --cans "$cans" --out "$results"
else
  echo "no built CaNS is named (--cans DIR): left out"
fi
# into PAGE OPTIONS...: puts the tables of a page between its marks
into() {
  bench/tables.py "${@:2}" >"$1.table"
  awk -v table="$1.table" '
    /^<!-- measured -->/ { print; print ""; while ((getline line < table) > 0) print line; inside = 1; next }
    /^<!-- end -->/ { inside = 0 }
    !inside' "$1" >"$1.part"
  mv "$1.part" "$1"
  rm "$1.table"
}
mapfile -t machines < <(printf '%s\n' bench/results/*/*-1.csv | xargs -n 1 dirname | uniq)
into docs/performance.md performance "${machines[@]}"
into docs/scaling.md growth "$results"
echo "the tables of docs/performance.md and docs/scaling.md are made of bench/results"
