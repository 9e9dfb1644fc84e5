#!/usr/bin/env bash
# The table of docs/performance.md, and those of docs/scaling.md of one machine, are what bench/tables.py makes of
# bench/results; its numbers are those by hand of a few rows (tables.py).     usage: page.sh SOURCE WORK
set -euo pipefail
source=$1 work=$2
rm -rf "$work" && mkdir -p "$work" && work=$(realpath "$work") && cd "$source"
fail() { echo "FAILED: $* (bench/run.sh makes it)" >&2; exit 1; }
python3 tests/program/bench/tables.py "$work"
in_page() { awk '/^<!-- measured -->/ { inside = 1; getline; next } /^<!-- end -->/ { inside = 0 } inside' "$1"; }
mapfile -t machines < <(printf '%s\n' bench/results/*/*-1.csv | xargs -n 1 dirname | uniq)
bench/tables.py performance "${machines[@]}" >"$work/performance"
in_page docs/performance.md | diff "$work/performance" - || fail "docs/performance.md has another table"
for machine in "${machines[@]}"; do
  bench/tables.py growth "$machine" >"$work/growth"
  if in_page docs/scaling.md | cmp -s "$work/growth" -; then exit 0; fi
done
fail "docs/scaling.md has other tables than those of any machine"
