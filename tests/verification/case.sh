#!/usr/bin/env bash
# A case of cases/verification from scratch, without touching its results. usage: case.sh FRANA SOURCE WORK CASE [quick]
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
rm -rf "$3"
exec "$2/cases/verification/$4/run.sh" "$1" "$3" "$3/results" "${5:-}"
