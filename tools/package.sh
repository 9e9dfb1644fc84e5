#!/usr/bin/env bash
# Packages of frana for any machine of this architecture: frana-VERSION-Linux.tar.gz, which can be unpacked anywhere,
# and on Debian frana_VERSION_ARCH.deb with its dependencies. Both use the system's libraries.
#   tools/package.sh [FOLDER [cmake's arguments]]     built in FOLDER (build-package), which then holds the packages
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=${1:-$root/build-package}
shift $(($# > 0))
generators=TGZ
! command -v dpkg-shlibdeps >/dev/null || generators='TGZ;DEB'
cmake -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=Release -DFRANA_ARCH= -DBUILD_TESTING=OFF \
    -DCMAKE_INSTALL_RPATH_USE_LINK_PATH=OFF -DCMAKE_INSTALL_PREFIX=/usr "$@"
cmake --build "$folder" --parallel "$(getconf _NPROCESSORS_ONLN)"
cd "$folder"
rm -f frana*.deb frana*.tar.gz
cpack -G "$generators"
ls -l frana*.deb frana*.tar.gz 2>/dev/null
