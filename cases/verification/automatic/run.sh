#!/usr/bin/env bash
# Scenes without steps, integrators and damping beside the same with a quarter of every step, judged by gates.yaml.
# usage: cases/verification/automatic/run.sh [FRANA [RUNS [OUT [quick]]]]
#        cases/verification/automatic/run.sh --summary [OUT]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
code=0
here=$here "$here/../gates.sh" "$@" || code=$?
if [ "${1-}" = --summary ] || [ "${4-}" ] || [ "$code" -gt 1 ]; then exit "$code"; fi
# one run of each scene says nothing of its time: README.md counts steps and sweeps
out=${3:-$here/results}
rm -f "$out"/study_*.md "$out"/study_*.png
sed -i '/^# advice on /d' "$out"/study_*.csv
exit "$code"
