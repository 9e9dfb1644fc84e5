#!/usr/bin/env bash
# The packages hold a program that runs where they are unpacked, and Debian's names what it needs.
# usage: package.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/program/common.sh" "$@"
"$source/tools/package.sh" "$PWD/build" >package.log 2>&1 || { tail -n 30 package.log; fail "tools/package.sh"; }

runs() { # FOLDER: the program below it runs one of its scenes
  frana=$PWD/$1/bin/frana
  ! readelf -d "$frana" | grep -E 'R(UN)?PATH' || fail "$1: a path of the machine it was built on"
  code 0 ranks 2 run "$1/share/frana/cases/channel/scene.yaml" --out "$1.run" --set stages.develop.steps=20 \
    --set output.fields_every=20
  grep -q '"status": *"done"' "$1.run/run.json" || fail "$1: the run is not done"
  [ -f "$1/share/man/man1/frana.1" ] || fail "$1: no manual page"
}
mkdir tarball && tar -C tarball --strip-components 1 -xzf build/frana-*.tar.gz
runs tarball
if command -v dpkg-deb >/dev/null; then
  dpkg-deb -x build/frana_*.deb root
  runs root/usr
  needs=$(dpkg-deb -f build/frana_*.deb Depends)
  for package in libc6 libhdf5 libfftw3-double3 liblapacke libyaml-0-2 libcairo2 libtiff6 'openmpi-bin|mpich'; do
    grep -Eq "(^|[ ,])($package)" <<<"$needs" || fail "the Debian package does not depend on $package: $needs"
  done
fi
echo ok
