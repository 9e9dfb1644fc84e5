#!/usr/bin/env bash
# All faults with which a run may end.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
scene | sed 's/fields_every: .*/fields_every: 0/' >scene.yaml # pictures take longest in what evaluates a run

# unstable: a step far above the limit; exit code 3, reports field, position and rank, writes the last good state
code 3 ranks 2 run scene.yaml --out nan --set stages.flow.time_step=1.0 --set output.series_every=1
grep -Eq 'unstable in step [0-9]+: (u|v|w|p) = .* at \(.*\) m on rank [01]' err ||
  { cat err; fail "no place in the message"; }
[ -f nan/checkpoint/latest ] || fail "the last good state was not kept"
grep -q '"status": *"unstable"' nan/run.json || fail "run.json does not say unstable"
code 0 ranks 1 run scene.yaml --out nan --resume

# a folder that contains a run is not overwritten
code 4 ranks 1 run scene.yaml --out nan
[ "$(grep -c '^frana:' err)" = 1 ] || { cat err; fail "more than one sentence"; }
# no checkpoint to resume from, and a file that is no checkpoint
code 4 ranks 1 run scene.yaml --out none --resume
echo rubbish >rubbish.h5
code 4 ranks 2 run scene.yaml --out none2 --resume=rubbish.h5
# a pipe, for which one would wait
mkfifo pipe.yaml
code 4 timeout 60 mpiexec -n 2 "$frana" run scene.yaml --out none3 --resume=pipe.yaml
code 2 timeout 60 "$frana" study pipe.yaml
grep -q 'it is not a file' err || fail "not said that a pipe is no study: $(cat err)"
# a checkpoint of another scene
code 5 ranks 2 run scene.yaml --out other --resume=nan/checkpoint/stage_flow.h5 --set domain.cells="[32, 16, 32]" \
  --set domain.size="[0.05, 0.025, 0.05]"
for folder in none none2 none3 other; do [ ! -e $folder ] || fail "a --resume that failed leaves $folder"; done
# frana post that is killed at its first plot: what it has begun has no final name, and its next call replaces it
mkdir killer && printf '#!/bin/sh\nkill -KILL $PPID\n' >killer/gnuplot && chmod +x killer/gnuplot
code 137 env PATH="$PWD/killer:$PATH" "$frana" post nan
[ -e nan/post/report.md.part ] || fail "post was killed too soon to say anything"
[ -z "$(find nan/post -type f ! -name '*.part' -size 0)" ] && [ ! -e nan/post/report.md ] &&
  [ ! -e nan/post/report.html ] || fail "a killed post leaves: $(find nan/post -type f)"
# stopped by a signal it leaves nothing behind, nor does gnuplot
printf '#!/bin/sh\nkill -TERM $PPID\nexec sleep 60\n' >killer/gnuplot && rm -r nan/post
code 75 env PATH="$PWD/killer:$PATH" "$frana" post nan
grep -q 'stopped by SIGTERM: nothing is kept of what is not finished' err || fail "no sentence: $(cat err)"
[ -n "$(find nan/post -name '*.gp')" ] && [ -z "$(find nan/post -name '*.part')" ] && [ ! -e nan/post/report.md ] ||
  fail "a stopped post leaves: $(find nan/post -type f)"
# a link and a pipe where gnuplot writes: nothing outside is touched, and nothing is waited for
echo precious >outside && ln -s "$PWD/outside" nan/post/plots/permeability.png.part
mkfifo nan/post/plots/permeability.svg.part
code 0 timeout -s KILL 100 "$frana" post nan
[ "$(cat outside)" = precious ] || fail "a plot is written through a link"
[ -s nan/post/report.md ] && [ -s nan/post/report.html ] && [ -z "$(find nan/post -name '*.part')" ] ||
  fail "after a killed post: $(find nan/post -type f)"
# limit on the run's wall time
code 75 ranks 2 run scene.yaml --out wall --max-wall 1 --set stages.flow.steps=1000000
grep -q -- '--max-wall' wall/run.log || fail "run.log does not say why it stopped"
# a command that goes on by itself names no option that it does not take
grep -q 'with a checkpoint: run again with --resume' wall/run.log || fail "not said how a run goes on"
code 75 ranks 1 calibrate scene.yaml --out calibrated --quick --max-wall 0.01
grep -q '^frana: calibrate: stopped before its last sample: the same command goes on' err || fail "$(cat err)"
grep -q ': the same command goes on' calibrated/*/*/run.log || fail "a sample that was stopped says another way"
# the command line
code 2 ranks 1
[ ! -s out ] && grep -q '^usage: frana COMMAND' err || { cat out err; fail "no command: the usage is no error"; }
code 0 ranks 1 help
[ ! -s err ] && grep -q '^usage: frana COMMAND' out || { cat out err; fail "frana help: not on standard output"; }
code 2 ranks 1 walk scene.yaml
# words of any kind: no control character and no long word reaches the terminal
long=$(printf 'x%.0s' {1..100000})
for words in "$long" "run $long" "run --$long" "help $long" "keys $long" "run scene.yaml --max-wall $long" \
  "check scene.yaml --set $long=1" "check scene.yaml --threads $long"; do
  # shellcheck disable=SC2086 # words
  code 2 ranks 1 $words
  [ "$(wc -c <err)" -lt 1000 ] || fail "a long word is printed whole: frana ${words:0:40}..."
done
for words in $'wa\e[31mlk' $'run x\e[31m.yaml' $'run scene.yaml --max-wall \e[31m' \
  $'check scene.yaml --set dom\e[31m=1'; do
  # shellcheck disable=SC2086
  code 2 ranks 1 $words
  ! grep -q $'\e' err || fail "a control character is printed: $(cat -v err)"
done
code 2 ranks 1 run
code 2 ranks 1 run scene.yaml --speed
code 2 ranks 1 run nowhere.yaml
code 2 ranks 1 run scene.yaml --max-wall soon
code 2 ranks 1 check scene.yaml --resume
code 2 ranks 7 check scene.yaml # 16 cells cannot be divided into seven pieces of three
code 0 mpiexec -n 1 "$frana" --version
grep -q HDF5 out || fail "--version does not name HDF5"
# a disk that is full behind standard output, a small stack, little memory
for words in schema keys help --version "check scene.yaml"; do
  got=0
  # shellcheck disable=SC2086 # words
  ranks 1 $words >/dev/full 2>err || got=$?
  [ $got = 4 ] && grep -q '^frana: the output cannot be written: ' err ||
    { cat err; fail "frana $words >/dev/full: $got"; }
done
code 2 bash -c "ulimit -s 64; exec '$frana' run scene.yaml --out small"
grep -q '^frana: the stack is limited to 64 kB' err || fail "a small stack: $(cat err)"
# from too little to begin with to enough: the end, or one sentence, and never a wait
for kB in 100000 150000 200000 250000 300000 400000 1000000; do
  got=0
  bash -c "ulimit -v $kB; exec timeout 300 '$frana' check scene.yaml" >out 2>err || got=$?
  [ $got = 0 ] || { [ $got -lt 10 ] && grep -q '^frana: .*no memory left' err; } ||
    fail "ulimit -v $kB: $got: $(tail -n 3 err)"
done
[ $got = 0 ] || fail "1 GB is too little: $(cat err)"
# two ranks by the launcher of another MPI: what it sets is not what the library reads
other=PMI_SIZE
grep -q '^MPI: Open MPI' out || other=OMPI_COMM_WORLD_SIZE
code 2 env $other=2 "$frana" --version
grep -q '^frana: .*2 ranks were started, and each runs alone' err || { cat err; fail "another MPI's launcher"; }
# a flow of which the cells hold nothing: said by the log too, or refused
cat >coarse.yaml <<'EOS'
title: a fast flow in few cells
domain: {size: [1, 1, 1], cells: [8, 8, 8]}
fluid:
  density: 1
  viscosity: 1.0e-6
  sides: {x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: periodic}, y_high: {type: periodic},
    z_low: {type: periodic}, z_high: {type: periodic}}
  driving: {type: bulk_velocity, value: 1}
stages: [{name: a, steps: 1, time_step: 1.0e-3}]
EOS
code 0 ranks 1 run coarse.yaml --out coarse
grep -q 'warning: the Reynolds number of a cell, U d/nu, is 1.25e+05: the run is hopeless' coarse/run.log ||
  fail "a cell Reynolds number of 1e5: $(cat coarse/run.log)"
code 2 ranks 1 run coarse.yaml --out coarser --set fluid.viscosity=1e-9
grep -q 'fluid.viscosity = 1e-9: the Reynolds number of a cell, U d/nu, is 1.25e+08, .* 1.25e-07 m2/s or more' err ||
  fail "a cell Reynolds number of 1e8: $(cat err)"
[ ! -e coarser ] || fail "a refused run has a folder"
# the same between given pressures, whose velocity is known only while it runs
sed -e 's/x_low: {type: periodic}/x_low: {type: pressure, pressure: 1}/' \
  -e 's/x_high: {type: periodic}/x_high: {type: pressure}/' \
  -e '/driving/d; s/steps: 1,/steps: 20,/; s/1.0e-6/1.0e-9/' coarse.yaml >pressed.yaml
code 3 ranks 1 run pressed.yaml --out pressed
grep -q 'the flow has become too fast for its cells by step 20: the Reynolds number of a cell, U d/nu, is .*e+06' err ||
  fail "a cell Reynolds number found in the run: $(cat err)"
[ -f pressed/checkpoint/latest ] || fail "the last good state was not kept"
code 0 ranks 1 run pressed.yaml --out slower --set fluid.viscosity=1.0e-6 --set output.series_every=0
grep -q 'warning: step 20: the Reynolds number of a cell, U d/nu, is .*e+03: the run is hopeless' slower/run.log ||
  fail "a cell Reynolds number of a thousand: $(cat slower/run.log)"
# a piston in a closed vessel: no flow displaces the fluid before it, and it goes through the piston; with a way round
# the piston it does not
cat >piston.yaml <<'EOS'
title: A piston in a closed vessel
domain: {size: [16, 10, 6], cells: [16, 10, 6]}
fluid:
  density: 1
  viscosity: 1
  sides: {x_low: {type: wall}, x_high: {type: wall}, y_low: {type: slip}, y_high: {type: slip},
    z_low: {type: slip}, z_high: {type: slip}}
solid:
  surface_correction: volume
  materials: [{name: s, youngs_modulus: 100, density: 1, horizon_ratio: 2}]
  bodies: [{name: piston, shape: box, low: [4, 0, 0], high: [8, 10, 6]}]
  constraints: [{low: [0, 0, 0], high: [16, 10, 6], velocity: [0.01, 0, 0]}]
stages: [{name: push, steps: 20, time_step: 0.1, breakage: false}]
output: {series_every: 10, fields_every: 0}
EOS
code 0 ranks 1 run piston.yaml --out piston
grep -q 'warning: stage push: at its end [0-9]* % of the power that the flow dissipates' piston/run.log ||
  fail "fluid goes through a piston, and nothing is said: $(cat piston/run.log)"
code 0 ranks 1 run piston.yaml --out round --set 'solid.bodies.piston.high=[8, 5, 6]' --set stages.push.steps=60
! grep -q 'warning: stage push: .* of the power' round/run.log || fail "a way round: $(cat round/run.log)"
# a colon in the path, which ROMIO takes for the end of a file system's name: at the start or not at all
code 0 ranks 1 --version
if grep -q '^MPI: Open MPI v4' out; then
  code 4 mpiexec --mca io romio321 -n 2 "$frana" run coarse.yaml --out co:lon
  grep -q '^frana: run folder co:lon: the MPI library cannot open a file whose path has a colon' err ||
    fail "a colon: $(cat err)"
  code 0 mpiexec --mca io ompio -n 2 "$frana" run coarse.yaml --out co:lon
fi
# an unknown key is reported before any file is written
echo 'oddity: 1' >>scene.yaml
code 2 ranks 2 run scene.yaml --out never
[ ! -e never ] || fail "a folder was made for a broken scene"
# and so is an invalid outline of a plate, which only its geometry shows
code 2 ranks 2 run "$source/tests/scene/scenes/plate.yaml" --out never \
  --set 'solid.bodies.plate.outline=[[0, 0], [0.05, 0.04], [0.05, 0], [0, 0.04]]'
grep -q 'crosses or touches itself' err || { cat err; fail "no sentence on the outline"; }
[ ! -e never ] || fail "a folder was made for an outline that crosses itself"
echo ok
