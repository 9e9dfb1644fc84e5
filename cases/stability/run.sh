#!/usr/bin/env bash
# Makes all maps, one after the other.
# usage: cases/stability/run.sh [FRANA [RUNS]]
set -euo pipefail
cd "$(dirname "$0")/../.."
frana=$(realpath "${1:-build/frana}") bad=0
for map in solid flow added_mass stiffness light forcing cavities start; do
  echo "== $map"
  "cases/stability/$map/run.sh" "$frana" "${2:-runs/stability}/$map" || bad=1
done
exit $bad
