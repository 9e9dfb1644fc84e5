#!/usr/bin/env bash
# Installs missing packages, builds, and runs all tests except the nightly ones.
#   ./test.sh              ./test.sh --nightly     the long ones too
#   ./test.sh -R fluid     whatever ctest takes: -R, -E, -L, --rerun-failed, ...; also the tests of single files
#   ./test.sh --sanitized  without the files on two ranks that the sanitizers have had, as in .ci/run
#   ./test.sh --batch      the job scripts of tools/batch alone, with a Slurm, whose packages it installs
#   ./test.sh --sanitize   under ASan and UBSan, on all numbers of ranks, built in build-debug: half an hour
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

select=(-LE "nightly|single")
options=() more=
folder=build flavour=() patience=600
for argument in "$@"; do
    case $argument in
    --nightly) select=(-LE single) FRANA_TARGET="all nightly" ;;
    --sanitized) select=(-LE "nightly|single|sanitized") ;;
    --batch) select=(-L batch) more=$packages_of_batch ;;
    --sanitize)
        folder=build-debug patience=6000
        flavour=(-DCMAKE_BUILD_TYPE=Debug -DFRANA_SANITIZE=ON -DFRANA_WERROR=ON)
        ;;
    *)
        options+=("$argument")
        select=(-LE nightly)
        ;;
    esac
done

# shellcheck disable=SC2086 # a list
setup_install $packages_of_tests $more
setup_build "$folder" "${flavour[@]}"
setup_mpi 4
# Open MPI leaks memory; tests/valgrind.sh finds leaks of frana itself
[ "$folder" = build ] || export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1
[ ! -t 1 ] || options=(--progress "${options[@]}")
exec ctest --test-dir "$folder" --output-on-failure --no-tests=error --timeout "$patience" \
    --parallel "$(setup_tests)" "${select[@]}" "${options[@]}"
