#!/usr/bin/env bash
# The tests of one rank on another processor: an arm64 root from Debian's packages, a cross build, and qemu. As root,
# because debootstrap wants it; needs debootstrap, gcc-aarch64-linux-gnu, qemu-user-static, cmake and ninja.
#   tools/aarch64.sh [ctest's arguments: -R solid_ ...]          SYSROOT=build-aarch64-root to keep the root elsewhere
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
sysroot=${SYSROOT:-$PWD/build-aarch64-root}

for command in debootstrap aarch64-linux-gnu-gcc qemu-aarch64-static cmake ninja; do
    command -v "$command" >/dev/null || {
        echo "$command is missing; Debian: apt-get install" \
            "debootstrap gcc-aarch64-linux-gnu qemu-user-static cmake ninja-build" >&2
        exit 2
    }
done

if [ ! -e "$sysroot/unpacked" ]; then
    echo "-- an arm64 root in $sysroot"
    packages=libc6-dev,libopenmpi-dev,libhdf5-openmpi-dev,libfftw3-dev,liblapacke-dev
    packages=$packages,libyaml-dev,libcairo2-dev,libtiff-dev,zlib1g-dev,libcmocka-dev
    debootstrap --foreign --arch=arm64 --variant=minbase \
        --include="$packages" \
        bookworm "$sysroot" >"$sysroot.log"
    for package in "$sysroot"/var/cache/apt/archives/*.deb; do dpkg-deb -x "$package" "$sysroot"; done
    # links that the packages' scripts would have made
    cd "$sysroot/usr/lib/aarch64-linux-gnu"
    for library in blas lapack; do
        ln -sf "$library-netlib.pc" "pkgconfig/$library.pc"
        ln -sf "$library/lib$library.so.3" "lib$library.so.3"
        ln -sf "$library/lib$library.so" "lib$library.so"
    done
    cd - >/dev/null
    touch "$sysroot/unpacked"
fi

cmake -S . -B build-aarch64 -G Ninja -DCMAKE_TOOLCHAIN_FILE="$PWD/tools/cmake/aarch64.cmake" \
    -DFRANA_SYSROOT="$sysroot" \
    -DFRANA_ARCH= \
    -DFRANA_WERROR=ON
ninja -C build-aarch64
ctest --test-dir build-aarch64 --output-on-failure -LE nightly "$@"
