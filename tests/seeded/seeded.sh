#!/usr/bin/env bash
# Thirteen faults of the scheme, each seeded into a copy of one source file: the program that is linked with it names
# them by its own watch, as a warning or as a reason to end, in scenes in which the program without them says nothing.
# By day the first fault that each message names; that the edits of all still fit is always checked.
# usage: seeded.sh FRANA SOURCE WORK, where FRANA stands in a folder that ninja builds in.
# An edit must fit in one place of its file, or the test fails: whoever changes that place mends the edit.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/../program/common.sh" "$@"
here=$source/tests/seeded build=$(dirname "$frana") clean=$frana found=0 work=$PWD
ninja -C "$build" -t commands frana >commands || fail "ninja has no commands for $frana"
link=$(tail -n 1 commands)

# seed FILE OLD NEW [OLD NEW]...: makes seeded.c, a changed copy of FILE
seed() {
  local text before; file=$1; shift
  text=$(<"$source/$file")
  for ((; $#; )); do
    before=${text%%"$1"*}
    [ "$before" != "$text" ] || fail "$file no longer has: $1"
    [[ ${text#"$before$1"} != *"$1"* ]] || fail "$file has more than once: $1"
    text=$before$2${text#"$before$1"}
    shift 2
  done
  printf '%s\n' "$text" >seeded.c
}
# Makes work/seeded, the program with seeded.c in place of $file. The changed object stands before the libraries, so
# what it defines is not taken from them.
build_seeded() {
  local compile
  compile=$(grep -F -- " -c $source/$file" commands) || fail "$file is in no library"
  (cd "$build" && eval "${compile%% -MD *} -w -o $work/seeded.o -c $work/seeded.c" &&
    eval "${link/ -o frana / $work/seeded.o -o $work/seeded }") >make.log 2>&1 || { cat make.log; fail "no build"; }
}

what_is() {
  case $1 in
  energy) echo "the solid's energy balance is off\|the energy balance is broken" ;;
  momentum) echo "the solid's momentum is off" ;;
  adjoint) echo "the fluid's drag does other work on the particles" ;;
  damping) echo 'damping has given back' ;;
  esac
}
# silent RANKS SCENE [--set ...]: nothing is said without a fault
silent() {
  local n=$1; shift
  frana=$clean
  rm -rf run && code 0 ranks "$n" run "$here/$1.yaml" --out run --quiet "${@:2}"
  ! grep "warning: step" run/run.log || fail "$1 is warned of without a fault"
}
# named "FAULT" WORD RANKS SCENE [--set ...]: the program with the fault that was seeded last says it
declare -A had # words
named() {
  local fault=$1 word=$2 n=$3 scene=$4; shift 4
  thorough || [ -z "${had[$word]-}" ] || return 0
  had[$word]=yes
  build_seeded
  frana=$work/seeded
  rm -rf run
  ranks "$n" run "$here/$scene.yaml" --out run --quiet "$@" >out 2>err || true
  grep -m 1 "$(what_is "$word")" run/run.log >line || { cat run/run.log; fail "not seen: $fault"; }
  found=$((found + 1))
  echo "$fault: $(sed 's/.*warning: //' line)"
}
damped=(--set stages.meet.damping_absolute=100)
# A heavy block is thrown against a wall.
thrown=(--set fluid.sides.y_low.type=wall --set fluid.sides.y_high.type=wall --set 'solid.bodies.0.velocity=[0,-1,0]'
  --set solid.materials.0.density=5)
silent 1 blocks
silent 1 blocks "${damped[@]}"
silent 1 stream
silent 2 stream
silent 1 stream "${thrown[@]}"

seed solid/step/verlet.c 'step = dt * (rate + 0.5 * dv);
        work' 'step = dt * (rate - 0.5 * dv);
        work'
named "the predictor's sign" energy 1 blocks
seed coupling/control/substeps.c 'return ceil(r->dt / (' 'return ceil(0.4 * r->dt / ('
named "a step too long" energy 1 blocks --set stages.meet.time_step=2.0e-4
seed coupling/load/reaction.c 'r->solid->load[c][h] += r->reaction->load[c][h]' 'r->solid->load[c][h] += 0'
named "a load lost in two stages of three" momentum 1 stream
seed solid/force/drag.c '+= w->share[k] * impulse[c]' '+= 1.1 * w->share[k] * impulse[c]'
named "a force that is not adjoint to the velocity" adjoint 1 stream
seed solid/force/drag.c 'par_ghost_add(s->ghost, 3, a->given, s->n);' ''
named "what ghosts got is lost" adjoint 2 stream
seed solid/force/force.c 'solid_force_loads(s, pairs, s->stage.damping_absolute)' \
  'solid_force_loads(s, pairs, -s->stage.damping_absolute)'
named "damping of the wrong sign" damping 1 blocks "${damped[@]}"
seed solid/contact/touching.c 'push[l[k]][i] -= to_l[k][i]' 'push[l[k]][i] -= 0 * to_l[k][i]'
named "contact of one side" momentum 1 blocks
seed coupling/load/reaction.c '    for (int i = 0; i < m->n; i++) {
        const double mass = ibm' '    if (stage == 0) add_to_load(r, (const double(*)[3])k->marker_force);
    for (int i = 0; i < m->n; i++) {
        const double mass = ibm' '    if (stage == 0)
        add_to_load(r, (const double(*)[3])k->marker_force);
    else' '    if (stage > 0)'
named "a pressure, in the markers' force, a step late" momentum 1 stream
seed solid/step/verlet.c 's->e_damped += 0.5 * dt * (damped +' 's->e_damped += 0 * dt * (damped +'
named "a missing term of dissipation" energy 1 blocks "${damped[@]}"
seed solid/force/drag.c 'drag->impulse[i][c] += impulse[c]' 'drag->impulse[i][c] += 2 * impulse[c]'
named "a drag that is booked twice" momentum 1 stream
seed solid/imposed/walls.c 'c == w->c ? w->into * k_h' 'c == w->c ? -w->into * k_h'
named "a wall that draws in place of pushing" energy 1 stream "${thrown[@]}"
seed solid/imposed/walls.c 'walls->now[c] += force;' 'walls->now[c] -= force;'
named "a wall's reaction with the wrong sign" momentum 1 stream "${thrown[@]}"
seed coupling/load/inner_fluid.c 'sum += load[h] * volume[h];' \
  'sum += load[h] * volume[h]; load[h] *= h % 4 != 0;'
named "the inner fluid's load on a quarter of the particles is lost" momentum 1 stream
of=$(by_day 4 13)
[ "$found" = "$of" ] || fail "$found faults of $of"
echo "$found faults are named"
