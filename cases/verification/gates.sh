#!/usr/bin/env bash
# Judges a case whose numbers are in gates.yaml; the case's run.sh is a link to this script, or calls it with the case's
# folder in $here.
# usage: CASE/run.sh [FRANA [RUNS [OUT [quick]]]]   makes the runs, and writes tables and verdicts
#        CASE/run.sh --summary [OUT]                judges the numbers in OUT again, with $FRANA or build/frana
set -euo pipefail
here=${here:-$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)}
if [ "${1-}" = --summary ]; then
  exec "${FRANA:-build/frana}" study "$here/gates.yaml" --collect --results "${2:-$here/results}"
fi
exec "${1:-build/frana}" study "$here/gates.yaml" --out "${2:-runs/verification/$(basename "$here")}" \
  --results "${3:-$here/results}" ${4:+--quick}
