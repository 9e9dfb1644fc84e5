#!/usr/bin/env bash
# The table of docs/performance.md, and those of docs/scaling.md of one machine, are what the program makes of
# bench/results.     usage: page.sh FRANA SOURCE WORK
set -euo pipefail
frana=$(realpath "$1") source=$2 work=$3
mkdir -p "$work" && work=$(realpath "$work") && cd "$source"
fail() { echo "FAILED: $* (bench/run.sh makes it)" >&2; exit 1; }
in_page() { awk '/^<!-- measured -->/ { inside = 1; getline; next } /^<!-- end -->/ { inside = 0 } inside' "$1"; }
"$frana" bench --table=performance bench/results/*/*-[12]*.csv bench/results/*/lammps.csv bench/results/*/cans.csv \
  bench/results/*/*/run.json >"$work/performance"
in_page docs/performance.md | diff "$work/performance" - || fail "docs/performance.md has another table"
for machine in bench/results/*/; do
  ls "$machine"*-[12].csv >/dev/null 2>&1 || continue
  "$frana" bench --table=growth "$machine"*-[12]*.csv >"$work/growth"
  if in_page docs/scaling.md | cmp -s "$work/growth" -; then exit 0; fi
done
fail "docs/scaling.md has other tables than those of any machine"
