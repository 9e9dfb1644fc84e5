#!/usr/bin/env bash
# Makes all maps, one after the other. Limits that this build has found already are kept.
# usage: cases/stability/run.sh [FRANA [RUNS]]
set -euo pipefail
cd "$(dirname "$0")/../.."
frana=$(realpath "${1:-build/frana}") runs=${2:-runs/stability}
bad=0
for map in solid flow added_mass stiffness light forcing cavities start; do
  echo "== $map"
  "cases/stability/$map/run.sh" "$frana" "$runs/$map" "cases/stability/$map/results" || bad=1
done
exit $bad
