#!/usr/bin/env bash
# docs/performance.md and the tables of docs/scaling.md are what the program makes of bench/results and bench/reference.
#     usage: page.sh FRANA SOURCE WORK
set -euo pipefail
frana=$(realpath "$1") source=$2 work=$3
mkdir -p "$work" && work=$(realpath "$work") && cd "$source"
fail() { echo "FAILED: $* (bench/run.sh makes it)" >&2; exit 1; }
"$frana" bench --table=performance bench/results/*.csv bench/reference/*.csv bench/results/*/run.json \
  >"$work/performance"
diff "$work/performance" docs/performance.md || fail "docs/performance.md is not of these results"
"$frana" bench --table=growth bench/results/*.csv >"$work/growth"
awk '/^<!-- measured -->/ { inside = 1; getline; next } /^<!-- end -->/ { inside = 0 } inside' docs/scaling.md |
  diff "$work/growth" - || fail "docs/scaling.md has other tables"
