#!/usr/bin/env bash
# Ten faults of the scheme, each seeded into a copy of the sources: the program that is built from it names them by its
# own watch, as a warning or as a reason to end, in scenes in which the program without them says nothing.
# usage: seeded.sh FRANA SOURCE WORK
# An edit must fit in one place of its file, or the test fails: whoever changes that place mends the edit.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/../program/common.sh" "$@"
here=$source/tests/seeded tree=$PWD/tree clean=$frana found=0
mkdir tree
tar -C "$source" --exclude=./.git --exclude='./build*' --exclude=./cases -cf - . | tar -C tree -xf -
make() {
  cmake --build tree/build --target frana --parallel 2 >make.log 2>&1 || { tail -n 30 make.log; fail "no build"; }
}
cmake -S tree -B tree/build -DBUILD_TESTING=OFF >make.log 2>&1 || { cat make.log; fail "not configured"; }

# edit FILE OLD NEW: in the copy
edit() {
  local text before
  text=$(<"$tree/$1") before=${text%%"$2"*}
  [ "$before" != "$text" ] || fail "$1 no longer has: $2"
  [[ ${text#"$before$2"} != *"$2"* ]] || fail "$1 has more than once: $2"
  printf '%s\n' "$before$3${text#"$before$2"}" >"$tree/$1"
}
# unseed FILE...: as it was
unseed() { for file; do cp "$source/$file" "tree/$file"; done; }

what_is() {
  case $1 in
  energy) echo "the solid's energy balance is off\|the energy balance is broken" ;;
  momentum) echo "the solid's momentum is off" ;;
  adjoint) echo "the fluid's drag does other work on the particles" ;;
  damping) echo 'damping and fracture have given back' ;;
  esac
}
# silent RANKS SCENE [--set ...]: nothing is said without a fault
silent() {
  local n=$1; shift
  frana=$clean
  rm -rf run && code 0 ranks "$n" run "$here/$1.yaml" --out run --quiet "${@:2}"
  ! grep "warning: step" run/run.log || fail "$1 is warned of without a fault"
}
# named "FAULT" WORD RANKS SCENE [--set ...]: the program with the fault says it
named() {
  local fault=$1 word=$2 n=$3 scene=$4; shift 4
  make
  frana=$tree/build/frana
  rm -rf run
  ranks "$n" run "$here/$scene.yaml" --out run --quiet "$@" >out 2>err || true
  grep -m 1 "$(what_is "$word")" run/run.log >line || { cat run/run.log; fail "not seen: $fault"; }
  found=$((found + 1))
  echo "$fault: $(sed 's/.*warning: //' line)"
}
damped=(--set stages.meet.damping_absolute=100)
silent 1 blocks
silent 1 blocks "${damped[@]}"
silent 1 stream
silent 2 stream

edit solid/step/verlet.c 'step = dt * (rate + 0.5 * dv);
        work' 'step = dt * (rate - 0.5 * dv);
        work'
named "the predictor's sign" energy 1 blocks
unseed solid/step/verlet.c
edit coupling/control/substeps.c 'return ceil(r->dt / (' 'return ceil(0.4 * r->dt / ('
named "a step too long" energy 1 blocks --set stages.meet.time_step=2.0e-4
unseed coupling/control/substeps.c
edit coupling/load/reaction.c 'r->solid->load[c][h] += r->reaction->load[c][h]' 'r->solid->load[c][h] += 0'
named "a load lost in two stages of three" momentum 1 stream
unseed coupling/load/reaction.c
edit solid/force/drag.c '+= w->share[k] * impulse[c]' '+= 1.1 * w->share[k] * impulse[c]'
named "a force that is not adjoint to the velocity" adjoint 1 stream
unseed solid/force/drag.c
edit solid/force/drag.c 'par_ghost_add(s->ghost, 3, a->given, s->n);' ''
named "what ghosts got is lost" adjoint 2 stream
unseed solid/force/drag.c
edit solid/force/force.c 'solid_force_loads(s, pairs, s->stage.damping_absolute)' \
  'solid_force_loads(s, pairs, -s->stage.damping_absolute)'
named "damping of the wrong sign" damping 1 blocks "${damped[@]}"
unseed solid/force/force.c
edit solid/contact/touching.c 'push[l[k]][i] -= to_l[k][i]' 'push[l[k]][i] -= 0 * to_l[k][i]'
named "contact of one side" momentum 1 blocks
unseed solid/contact/touching.c
edit coupling/load/reaction.c '    for (int i = 0; i < m->n; i++) {
        const double mass = ibm' '    if (stage == 0) add_to_load(r, (const double(*)[3])k->marker_force);
    for (int i = 0; i < m->n; i++) {
        const double mass = ibm'
edit coupling/load/reaction.c '    if (stage == 0)
        add_to_load(r, (const double(*)[3])k->marker_force);
    else' '    if (stage > 0)'
named "a pressure, in the markers' force, a step late" momentum 1 stream
unseed coupling/load/reaction.c
edit solid/step/verlet.c 's->e_damped += 0.5 * dt * (damped +' 's->e_damped += 0 * dt * (damped +'
named "a missing term of dissipation" energy 1 blocks "${damped[@]}"
unseed solid/step/verlet.c
edit solid/force/drag.c 'drag->impulse[i][c] += impulse[c]' 'drag->impulse[i][c] += 2 * impulse[c]'
named "a drag that is booked twice" momentum 1 stream
[ $found = 10 ] || fail "$found faults of ten"
echo "$found faults are named"
