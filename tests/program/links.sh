#!/usr/bin/env bash
# Symbolic links and pipes in a run folder: nothing outside is written, and nothing is waited for.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'EOS'
title: a small block
domain: {size: [4, 4, 4]}
solid:
  spacing: 0.5
  materials: [{name: s, youngs_modulus: 1.0e9, density: 2000}]
  bodies: [{shape: box, low: [1, 1, 1], high: [3, 3, 3]}]
stages: [{name: a, steps: 2}]
output: {series_every: 1, fields_every: 1, checkpoint_every: 1}
EOS
alone="timeout -s KILL 60"
run() { $alone "$frana" run scene.yaml --out "$@" >out 2>err; }
echo precious >outside
# each file that a run writes under its own name, a link to a file outside, a dangling one, a pipe
for name in run.log run.lock series.csv; do
  for kind in link dangling pipe; do
    rm -rf run there && mkdir -p run/checkpoint run/fields
    case $kind in
    link) ln -s ../outside run/$name ;;
    dangling) ln -s ../there run/$name ;;
    pipe) mkfifo run/$name ;;
    esac
    got=0
    run run || got=$?
    [ $got = 4 ] || { cat out err; fail "$kind in place of $name: exit code $got"; }
    [ "$(wc -l <err)" = 1 ] && grep -Eq 'symbolic link|it is not a regular file|holds a run already' err ||
      fail "$kind in place of $name: $(cat err)"
    [ "$(cat outside)" = precious ] && [ ! -e there ] || fail "written through a $kind in place of $name"
  done
done
# temporary files are replaced, whatever stands in their place
for name in run.json scene.resolved.yaml checkpoint/step_00000001.h5 checkpoint/latest fields/solid_00000001.hdf; do
  for kind in link pipe; do
    rm -rf run && mkdir -p run/checkpoint run/fields
    [ $kind = link ] && ln -s "$PWD/outside" run/$name.part || mkfifo run/$name.part
    run run || { cat out err; fail "$kind in place of $name.part: exit code $?"; }
    [ "$(cat outside)" = precious ] || fail "written through a link in place of $name.part"
    [ ! -e run/$name.part ] && [ ! -L run/$name.part ] || fail "left behind: $name.part"
  done
done
# what a resumed run reads
for name in checkpoint/latest run.json series.csv fields/solid_00000002.hdf; do
  cp -r run piped
  rm piped/$name && mkfifo piped/$name
  got=0
  run piped --resume || got=$?
  [ $got != 137 ] || fail "waits for a pipe in place of $name"
  timeout -s KILL 60 "$frana" post piped >out 2>err || [ $? != 137 ] || fail "post waits for a pipe in place of $name"
  rm -rf piped
done
# files in the user's cache: a pipe in place of each that a run makes there
export XDG_CACHE_HOME=$PWD/cache
cat >flow.yaml <<'EOS'
title: a flow whose transforms are those of FFTW
domain: {size: [1, 1, 1], cells: [8, 67, 8]}
fluid:
  density: 1
  viscosity: 1
  sides: {x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: periodic}, y_high: {type: periodic},
    z_low: {type: periodic}, z_high: {type: periodic}}
stages: [{name: a, steps: 1, time_step: 1.0e-6}]
EOS
code 0 ranks 1 run flow.yaml --out flow
[ -n "$(ls cache/frana)" ] || fail "nothing in the cache"
for f in cache/frana/*; do rm "$f" && mkfifo "$f"; done
code 0 timeout -s KILL 100 "$frana" run flow.yaml --out again
echo ok
