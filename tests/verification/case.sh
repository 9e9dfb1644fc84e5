#!/usr/bin/env bash
# Runs a case of cases/verification from the beginning without changing its results. usage: case.sh FRANA SOURCE WORK
# CASE [quick]
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
rm -rf "$3"
exec "$2/cases/verification/$4/run.sh" "$1" "$3" "$3/results" "${5:-}"
