#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests: all but the nightly ones.
#   ./test.sh              ./test.sh --nightly     the long ones too
#   ./test.sh -R fluid     whatever ctest takes: -R, -E, -L, --rerun-failed, ...
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

select=(-LE nightly)
options=()
for argument in "$@"; do
    case $argument in
    --nightly) select=() ;;
    *) options+=("$argument") ;;
    esac
done

# shellcheck disable=SC2086 # a list
setup_install $packages_of_tests
setup_build build
setup_mpi 4
[ ! -t 1 ] || options=(--progress "${options[@]}")
exec ctest --test-dir build --output-on-failure --no-tests=error --timeout 600 --parallel "$(setup_cores)" "${select[@]}" "${options[@]}"
