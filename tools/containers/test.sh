#!/usr/bin/env bash
# Builds the images of the Dockerfile and of frana.def, and runs the demonstration in them. Root, on Debian; needs
# buildah and debootstrap. The base is made by debootstrap, so that no registry of images is asked. Apptainer itself is
# not run: the sections of frana.def are executed in containers, in the order and with the variables of its manual.
#   tools/containers/test.sh [docker] [apptainer]     both, if none is named; in build-containers
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$root/build-containers
export STORAGE_DRIVER=${STORAGE_DRIVER:-vfs} BUILDAH_ISOLATION=chroot # work within a container too
mkdir -p "$work"
cd "$work"

say() { printf '%s\n' "-- $*"; }
fail() {
    printf '%s\n' "failed: $*" >&2
    exit 1
}
quietly() { # LOG COMMAND...
    local log=$1
    shift
    "$@" >"$log" 2>&1 || { tail -n 30 "$log" >&2 && fail "$*; the whole output is in $log"; }
}
images() { buildah --root "$work/images" --runroot "$work/running" "$@"; }
container() { # NAME IMAGE: a new container of that name; prints where its files are
    images rm "$1" >/dev/null 2>&1 || true
    images from --name "$1" "$2" >/dev/null
    images mount "$1"
}

base() {
    ! images inspect frana-base >/dev/null 2>&1 || return 0
    say "debootstrap of Debian 12 (output in $work/base.log)"
    rm -rf base
    quietly base.log debootstrap --variant=minbase bookworm base
    tar -C base -cf base.tar .
    images rm base >/dev/null 2>&1 || true
    images from --name base scratch >/dev/null
    images add -q base base.tar / >/dev/null
    images commit -q base frana-base >/dev/null
    images rm base >/dev/null
    rm -rf base base.tar
}

# demonstration CONTAINER [COMMAND]: the small porous block on two ranks, as a user who is not root and has no home.
# COMMAND is executed before the program: what sets its environment, if the image does not.
demonstration() {
    local folder=$work/run-$1 before=${2:-true}
    rm -rf "$folder"
    mkdir -m 1777 "$folder"
    local inside=(images run --network host --user 1000:1000 -v "$folder:/work" --workingdir /work "$1" -- sh -ec)
    "${inside[@]}" "$before; frana --version" | tee "$folder.version"
    grep -qF "($(git -C source describe --always))" "$folder.version" || fail "$1: not the version of the sources"
    say "the demonstration in $1 (output in $folder.log)"
    quietly "$folder.log" "${inside[@]}" "$before
        mpiexec --oversubscribe -n 2 frana run /usr/share/frana/cases/porous_channel/demo.yaml --out demo
        frana post demo"
    ! grep -iE 'warning|error:' "$folder.log" || fail "$1: a warning, in $folder.log"
    grep -q '"status": *"done"' "$folder/demo/run.json" || fail "$1: the run is not done"
    [ -s "$folder/demo/post/summary.csv" ] || fail "$1: no summary"
    ls "$folder"/demo/post/pictures/*.png >/dev/null || fail "$1: no picture"
}

docker() {
    say "the image of the Dockerfile (output in $work/docker.log)"
    quietly docker.log images build --layers --network host --build-arg BASE=localhost/frana-base \
        -f source/tools/containers/Dockerfile -t frana source
    container docker localhost/frana >/dev/null
    demonstration docker
    images images localhost/frana
}

# section STAGE NAME: the text of a section of frana.def, with the defaults of %arguments
section() {
    awk -v stage="$1" -v name="$2" '
        /^Stage: / { here = $2 == stage }
        /^%arguments/ { arguments = 1; within = 0; next }
        /^%/ { arguments = 0; within = here && substr($0, 2) == name; next }
        /^Bootstrap: / { within = arguments = 0 }
        arguments && /=/ { sub(/^ +/, ""); n = index($0, "="); value[substr($0, 1, n - 1)] = substr($0, n + 1) }
        within { for (v in value) gsub("{{ *" v " *}}", value[v]); print }' "$work/source/tools/containers/frana.def"
}

apptainer() {
    local build final from to
    say "the sections of frana.def (output in $work/apptainer-*.log)"
    build=$(container apptainer-build localhost/frana-base)
    final=$(container apptainer localhost/frana-base)
    rm -rf "$build/frana"
    (cd source && APPTAINER_ROOTFS=$build quietly ../apptainer-setup.log sh -ec "$(section build setup)")
    quietly apptainer-build.log images run --network host apptainer-build -- sh -ec "$(section build post)"
    while read -r from to; do
        [ -z "$from" ] || cp -r "$build$from" "$final$to"
    done < <(section final "files from build")
    quietly apptainer-final.log images run --network host apptainer -- sh -ec "$(section final post)"
    quietly apptainer-test.log images run --network host apptainer -- \
        sh -ec "$(section final environment); $(section final test)"
    demonstration apptainer "$(section final environment)"
}

base
rm -rf source
git clone -q "$root" source # a clean checkout, whatever the folder holds
if [ $# = 0 ]; then set -- docker apptainer; fi
for kind; do "$kind"; done
say "ok"
