#!/usr/bin/env bash
# Builds frana with each compiler, MPI and kind of libraries, and runs the tests with the label smoke in each build:
# each file on two ranks or on one, and the installed tree. Without optimisation (-O0), because compiling takes most of
# the time.
#   tools/builds.sh [COMPILER-MPI-KIND ...]     as gcc-mpich-shared; by default all eight: gcc|clang,
#               openmpi|mpich, static|shared. BUILDS=FOLDER: where they are built (the current clone)
set -euo pipefail
# shellcheck source=tools/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
builds=$(realpath "${BUILDS:-.}")
[ $# != 0 ] || set -- {gcc,clang}-{openmpi,mpich}-{static,shared}

packages_of_builds=()
for build; do
    case $build in
    gcc-openmpi-static | gcc-openmpi-shared) ;;
    gcc-mpich-static | gcc-mpich-shared) packages_of_builds+=(libmpich-dev mpich libhdf5-mpich-dev) ;;
    clang-openmpi-static | clang-openmpi-shared) packages_of_builds+=(clang) ;;
    clang-mpich-static | clang-mpich-shared) packages_of_builds+=(clang libmpich-dev mpich libhdf5-mpich-dev) ;;
    *) echo "$build: must be {gcc,clang}-{openmpi,mpich}-{static,shared}" >&2; exit 2 ;;
    esac
done
# shellcheck disable=SC2086,SC2154 # a list, from setup.sh
setup_install $packages_of_tests "${packages_of_builds[@]}"
setup_mpi 2

for build; do
    IFS=- read -r compiler mpi kind <<<"$build"
    folder=$builds/build-$build shared=OFF
    [ "$kind" = static ] || shared=ON
    # Debian's names of the wrappers; elsewhere the one in PATH
    wrapper=$(command -v "mpicc.$mpi" || command -v mpicc)
    FRANA_TARGET=smoke setup_build "$folder" -DCMAKE_C_COMPILER="$compiler" -DMPI_C_COMPILER="$wrapper" \
        -DBUILD_SHARED_LIBS="$shared" -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS=-O0 -DFRANA_WERROR=ON
    # MPICH's ranks do not yield: never more of them than cores
    setup_quietly "the smoke tests of $build" "$folder/log/test.log" \
        ctest --test-dir "$folder" --output-on-failure --no-tests=error --timeout 300 -L smoke \
        --parallel "$(setup_cores)"
    grep 'tests passed' "$folder/log/test.log"
done
