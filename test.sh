#!/usr/bin/env bash
# Installs missing packages, builds, and runs all tests except the nightly ones.
#   ./test.sh              ./test.sh --nightly     the long ones too
#   ./test.sh -R fluid     whatever ctest takes: -R, -E, -L, --rerun-failed, ...; also the tests of single files
#   ./test.sh --batch      the job scripts of tools/batch alone, with a Slurm, whose packages it installs
#   ./test.sh --sanitize   the same tests under ASan and UBSan by clang, built in build-debug
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/tools/setup.sh"

select=(-LE "nightly|single")
options=() more=
folder=build flavour=() patience=600
for argument in "$@"; do
    case $argument in
    --nightly) select=(-LE single) FRANA_TARGET="all nightly" more=hdf5-tools ;; # h5dump: scripts of cases
    --batch) select=(-L batch) more=$packages_of_batch ;;
    --sanitize)
        folder=build-debug patience=6000
        # by clang, the other compiler; lld links a program with the sanitizers in a fifth of the time of ld
        flavour=(-DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_COMPILER=clang -DFRANA_SANITIZE=ON -DFRANA_WERROR=ON
            -DFRANA_DEBUG_INFO=-g1 -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld)
        more="clang libclang-rt-dev lld"
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
