# shellcheck shell=bash
# Common to demo.sh, test.sh and .ci/run: installation of missing packages, and building. To be sourced by bash.
#
#   setup_install [clang...]  what frana needs (Debian: by apt), and the packages named: $packages_of_tests,
#                             $packages_of_batch, clang, ...
#   setup_build DIR [args]    configures (cmake, with args) and builds, all or the targets that $FRANA_TARGET names
#   setup_mpi                 the environment in which mpiexec runs as any user, in a container, on few cores

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit

packages="cmake ninja-build gcc libc6-dev pkg-config git libopenmpi-dev openmpi-bin libhdf5-openmpi-dev libfftw3-dev
    liblapacke-dev libopenblas-serial-dev libyaml-dev libcmocka-dev libcairo2-dev libtiff-dev
    zlib1g-dev gnuplot-nox"
# shellcheck disable=SC2034 # for whoever sources this
packages_of_tests="python3-vtk9 python3-numpy python3-h5py" # independent readers of the field files
# shellcheck disable=SC2034
packages_of_batch="munge slurmctld slurmd slurm-client" # a Slurm for the test of the job scripts
# shellcheck disable=SC2034
packages_of_site="mkdocs mkdocs-material katex nodejs" # tools/site.sh
commands="cmake mpiexec gnuplot"

say() { printf '%s\n' "-- $*"; }
# setup_quietly WHAT LOG COMMAND...: the output goes to LOG. On a terminal the log's last line is shown while the
# command runs; otherwise one line at the start and one at the end.
setup_quietly() {
    local what=$1 log=$2 from=$SECONDS status=0 pid width
    shift 2
    mkdir -p "$(dirname "$log")"
    if [ -t 1 ]; then
        width=$(($(tput cols 2>/dev/null || echo 80) - 1))
        "$@" >"$log" 2>&1 </dev/null &
        pid=$!
        while kill -0 "$pid" 2>/dev/null; do
            printf '\r%-*.*s' "$width" "$width" \
                "-- $what, $((SECONDS - from)) s: $(tail -n 1 "$log" | tr -d '\r' | tr -c '[:print:]' ' ')"
            sleep 0.5
        done
        wait "$pid" || status=$?
        printf '\r%-*.*s\r' "$width" "$width" ""
    else
        say "$what (output in $log)"
        "$@" >"$log" 2>&1 </dev/null || status=$?
    fi
    if [ "$status" != 0 ]; then
        tail -n 30 "$log" >&2
        printf '%s\n' "$what failed; the whole output is in $log" >&2
        return "$status"
    fi
    say "$what: done in $((SECONDS - from)) s"
}

# Prints the commands that are missing, one a line. CMake says which libraries are (docs/install.md).
setup_lacking() {
    local name
    for name in $commands; do command -v "$name" >/dev/null 2>&1 || echo "$name (command)"; done
}

setup_apt() {
    local as_root=$1
    shift
    # the list of packages may be out of date or missing
    $as_root apt-get -o DPkg::Lock::Timeout=300 update -q
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 install -q -y \
        --no-install-recommends "$@"
}

# Packages cannot be installed from here, because of $1: continues if everything needed is there.
setup_without() {
    local lacking
    lacking=$(setup_lacking)
    if [ -n "$lacking" ]; then
        printf '%s\n' "$1, and these are lacking:" "$lacking" "Debian's names of the packages that frana needs:" \
            "    ${packages//$'\n'    /$'\n'        }" >&2
        exit 1
    fi
    say "$1; CMake finds out whether the libraries are there"
}

setup_install() {
    local name missing=() as_root=""
    if ! command -v apt-get >/dev/null 2>&1 || ! command -v dpkg-query >/dev/null 2>&1; then
        setup_without "no apt-get here"
        return
    fi
    for name in $packages "$@"; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null || true)" = installed ] || missing+=("$name")
    done
    [ ${#missing[@]} != 0 ] || return 0
    say "installing: ${missing[*]}"
    if [ "$(id -u)" != 0 ]; then
        as_root=sudo
        if ! command -v sudo >/dev/null 2>&1 || ! sudo -v; then
            setup_without "not root and no sudo (as root: apt-get install ${missing[*]})"
            return
        fi
    fi
    setup_quietly "apt-get install of ${#missing[@]} packages" build/log/apt.log setup_apt "$as_root" "${missing[@]}" ||
        setup_without "apt-get could not install all of: ${missing[*]}"
}

setup_build() {
    local dir=$1 generator=()
    shift
    # a build folder that was configured by another checkout is configured again
    if [ -f "$dir/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$dir/CMakeCache.txt"; then
        rm -rf "$dir/CMakeCache.txt" "$dir/CMakeFiles"
    fi
    [ -f "$dir/CMakeCache.txt" ] || ! command -v ninja >/dev/null 2>&1 || generator=(-G Ninja)
    setup_quietly "configuring $dir" "$dir/log/configure.log" cmake -S "$root" -B "$dir" "${generator[@]}" "$@"
    # shellcheck disable=SC2086 # a list
    setup_quietly "building $dir" "$dir/log/build.log" cmake --build "$dir" --parallel "$(setup_cores)" \
        ${FRANA_TARGET:+--target $FRANA_TARGET}
}

setup_cores() { getconf _NPROCESSORS_ONLN; }
# ranks at a time: a test waits for much of its time, for ranks to start and end; and a test of three ranks must find
# its place on two cores
setup_tests() { echo $((3 * $(setup_cores))); }

setup_mpi() {
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
    export OMPI_MCA_btl_vader_single_copy_mechanism=none # forbidden in containers; Open MPI would complain
    [ "$(setup_cores)" -ge "${1:-2}" ] || export OMPI_MCA_mpi_yield_when_idle=1
}
