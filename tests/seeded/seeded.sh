#!/usr/bin/env bash
# Faults of the scheme, each seeded into a copy of one source file: the program that is linked with it names them by its
# own watch, as a warning or as a reason to end, in scenes in which the program without them says nothing.
# By day three programs, with one fault for each of the watch's messages, several at once; that the edits of all still
# fit is always checked.
# usage: seeded.sh FRANA SOURCE WORK, where FRANA stands in a folder that ninja builds in.
# An edit must fit in one place of its file, or the test fails: whoever changes that place mends the edit.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/../program/common.sh" "$@"
here=$source/tests/seeded build=$(dirname "$frana") clean=$frana found=0 work=$PWD files=()
ninja -C "$build" -t commands frana >commands || fail "ninja has no commands for $frana"
link=$(tail -n 1 commands)

# seed FILE OLD NEW [OLD NEW]...: makes seeded.c, a changed copy of FILE, in the place of those that were seeded before
seed() { files=(); also "$@"; }
# also FILE OLD NEW [OLD NEW]...: and of another file
also() {
  local file=$1 copy="seeded_${#files[@]}.c"; shift
  files+=("$file")
  cp "$source/$file" "$copy"
  for ((; $#; )); do
    old=$1 new=$2 awk 'BEGIN { RS = "\001"; old = ENVIRON["old"]; n = length(old) }
      { at = index($0, old); rest = substr($0, at + n)
        if (at == 0 || index(rest, old) > 0) exit 1
        printf "%s%s%s", substr($0, 1, at - 1), ENVIRON["new"], rest }' "$copy" >edited.c ||
      fail "$file does not have once: $1"
    mv edited.c "$copy"
    shift 2
  done
}
# Makes work/seeded, the program with the changed copies in place of $files. The changed objects stand before the
# libraries, so what they define is not taken from them.
build_seeded() {
  local compile k objects=""
  for k in "${!files[@]}"; do
    compile=$(grep -F -- " -c $source/${files[k]}" commands) || fail "${files[k]} is in no library"
    objects+=" $work/seeded_$k.o"
    (cd "$build" && eval "${compile%% -MD *} -w -o $work/seeded_$k.o -c $work/seeded_$k.c") >make.log 2>&1 ||
      { cat make.log; fail "no build"; }
  done
  (cd "$build" && eval "${link/ -o frana /$objects -o $work/seeded }") >make.log 2>&1 ||
    { cat make.log; fail "no build"; }
}

what_is() {
  case $1 in
  energy) echo "the solid's energy balance is off\|the energy balance is broken" ;;
  momentum) echo "the solid's momentum is off" ;;
  adjoint) echo "the fluid's drag does other work on the particles" ;;
  damping) echo 'damping has given back' ;;
  reaction) echo 'the forces of the markers on solid and fluid are not opposite' ;;
  inner) echo 'the fluid inside the solid has given back' ;;
  fluid) echo "the fluid's momentum is off" ;;
  angular) echo "the fluid's angular momentum is off" ;;
  divergence) echo "the flow's divergence is up to" ;;
  cracks) echo 'the volume of the fluid in cracks is off' ;;
  push) echo 'the pressures in cracks do other work on the solid' ;;
  leak) echo 'of the fluid that has leaked off the cracks' ;;
  flow) echo "the flow's energy is off" ;;
  esac
}
# The scene of this name: of this test, or made above
yaml() { if [ -e "$work/$1.yaml" ]; then echo "$work/$1.yaml"; else echo "$here/$1.yaml"; fi; }
# silent RANKS SCENE [--set ...]: nothing is said without a fault
silent() {
  local n=$1; shift
  frana=$clean
  rm -rf run && code 0 ranks "$n" run "$(yaml "$1")" --out run --quiet "${@:2}"
  ! grep "warning: step" run/run.log || fail "$1 is warned of without a fault"
}
# run_seeded RANKS SCENE [--set ...]: runs the program with the faults that were seeded last
run_seeded() {
  build_seeded
  frana=$work/seeded
  rm -rf run
  ranks "$1" run "$(yaml "$2")" --out run --quiet "${@:3}" >out 2>err || true
}
# said "FAULT" WORD: the last run has said it
said() {
  grep -m 1 "$(what_is "$2")" run/run.log >line || { cat run/run.log; fail "not seen: $1"; }
  echo "$1: $(sed 's/.*warning: //' line)"
}
# named "FAULT" WORD RANKS SCENE [--set ...]: the program with the fault that was seeded last says it
named() {
  thorough || return 0
  run_seeded "${@:3}"
  said "$1" "$2"
  found=$((found + 1))
}
damped=(--set stages.meet.damping_absolute=100)
# A heavy block is thrown against a wall.
thrown=(--set fluid.sides.y_low.type=wall --set fluid.sides.y_high.type=wall --set 'solid.bodies.0.velocity=[0,-1,0]'
  --set solid.materials.0.density=5)
walls=(--set fluid.sides.y_low.type=wall --set fluid.sides.y_high.type=wall)
forced=(--set 'fluid.body_force=[0.01,0,0]')
open=(--set fluid.sides.x_low.type=inflow --set fluid.sides.x_low.bulk_velocity=0.1 --set \
  fluid.sides.x_high.type=outflow)
oblique=(--set 'fluid.initial.velocity=[0.1,0.05,0]')
implicit=(--set fluid.diffusion=implicit)
driven=(--set 'fluid.driving={type: pressure_gradient, value: 1}' --set 'fluid.initial={velocity: [0, 0, 0]}'
  --set fluid.viscosity=0.05 --set stages.meet.steps=100)
# Bonds break in every substep, also in the last one before a row.
torn=(--set solid.materials.0.fracture_energy=20 --set crack_fluid.injections.0.rate=2.0e-3 --set output.series_every=1
  --set stages.pump.steps=5)
# As much fluid is taken out as is given.
through=(--set crack_fluid.leak_off=0 --set crack_fluid.least_pressure=-1.0e9 --set crack_fluid.least_aperture=1.0e-5
  --set 'crack_fluid.injections=[{low: [0.009, 0.012], high: [0.01, 0.018], rate: 1.0e-9},
    {low: [0.02, 0.012], high: [0.021, 0.018], rate: -1.0e-9}]' --set stages.pump.steps=200)
fragile=(--set solid.materials.0.fracture_energy=1.0e-2)
sed 's/  leak_off:.*/  pores: {permeability: 1.0e-13, biot: 0.7, modulus: 2.0e10}/' "$here/crack.yaml" >pores.yaml
for scene in blocks stream deep crack vortices; do silent 1 $scene; done
silent 1 blocks "${damped[@]}"
silent 1 crack "${torn[@]}"
silent 1 crack "${through[@]}"
if thorough; then
  silent 2 stream
  silent 1 stream "${thrown[@]}"
  silent 1 stream "${walls[@]}"
  silent 1 stream "${forced[@]}"
  silent 1 deep "${forced[@]}"
  silent 1 stream "${oblique[@]}"
  silent 1 stream "${open[@]}" "${oblique[@]}"
  silent 1 stream "${implicit[@]}" "${walls[@]}"
  silent 1 blocks "${fragile[@]}"
  silent 1 blocks --set stages.meet.damping_relative=1.0e13
  silent 1 pores
  silent 1 vortices "${walls[@]}" "${driven[@]}"
fi

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
seed solid/force/attachment.c 'w->own * force[i][c]' '0.9 * w->own * force[i][c]'
named "a marker's force of which its own particle gets too little" momentum 1 stream
seed solid/imposed/external_loads.c 'load[g->touch[i]] += sum[g->touch[i]];' \
  'load[g->touch[i]] += 1.1 * sum[g->touch[i]];'
named "a load that acts by more than is booked" momentum 1 blocks
seed solid/force/sweep_lattice.c '    s->flag[h] |= SOLID_BROKEN;
    s->e_fracture += energy;' '    s->flag[h] |= SOLID_BROKEN;'
named "a bond's energy that is booked for one of its ends" energy 1 blocks "${fragile[@]}"
seed solid/step/verlet.c 's->e_constraint += 0.5 * dt *' 's->e_constraint += 0.25 * dt *'
named "half of a constraint's work" energy 1 blocks
seed solid/step/verlet.c 'work = -0.5 * dt * dt * solid_contact' 'work = 0.5 * dt * dt * solid_contact'
named "contact's part of what damped pairs take, with the wrong sign" energy 1 blocks --set \
  stages.meet.damping_relative=1.0e13
seed solid/step/verlet.c 's->e_integrator -= 0.125' 's->e_integrator += 0.125'
named "the integrator's part with the wrong sign" energy 1 stream
seed coupling/load/reaction.c 'density * m->volume[i] : 0' '1.1 * density * m->volume[i] : 0'
named "a marker's volume that the solid feels and the fluid does not" reaction 1 stream
seed coupling/load/reaction.c '-by_drag / all : 0' '-0.9 * by_drag / all : 0'
named "a slip that gives the fluid too little" reaction 1 stream
seed coupling/load/inner_fluid.c '- a.any * excess[h],' '+ a.any * excess[h],'
named "what was given too much is given once more" inner 1 stream
seed coupling/load/inner_fluid.c 'coming - (1 - ahead) * a.gamma * gain' 'coming - (1 - ahead) * gain'
named "a stage's excess without its length" inner 1 stream
seed coupling/load/inner_fluid.c '(1 - to_fluid[h]) * all' 'all'
named "the share of the fluid deep inside goes to the particles too" inner 1 deep
seed coupling/load/inner_fluid.c '+ body_force - k->mean[c]) * length / density' \
  '+ body_force - k->mean[c]) * 0.9 * length / density'
named "a push that is too weak" inner 1 deep
seed coupling/load/inner_fluid.c 'if (!k->pushes) return;' 'if (!k->pushes || stage == 2) return;'
named "a push that is lost in the last stage" inner 1 deep
seed coupling/load/inner_fluid.c '+ body_force - k->mean[c]) * length' '+ body_force) * length'
named "the mean acceleration is given to particles and fluid" inner 1 deep "${forced[@]}"
seed coupling/load/inner_fluid.c 'if (k->pushes) ibm_couple_forcing' 'if (0) ibm_couple_forcing'
named "the couple of the push is lost" angular 1 deep --set 'solid.bodies.0.low=[4,1,3]'
seed ibm/sweep.c 'lean = 0.5 * t' 'lean = -0.5 * t'
named "weights of the kernel that lean the wrong way" angular 1 stream
seed fluid/measure/box_couple.c 'arm[d] = g->length[d];' 'arm[d] = 0.5 * g->length[d];'
named "a period's arm that is too short" angular 1 stream "${oblique[@]}"
seed ibm/feedback.c 'ibm->increment[h][c] = direct;' 'ibm->increment[h][c] = 1.1 * direct;'
named "spreading of more than is counted" fluid 1 stream
seed fluid/momentum/momentum.c 's->c * s->source[c]' '0.9 * s->c * s->source[c]'
named "a body force that acts by less than is booked" fluid 1 stream "${forced[@]}"
seed fluid/momentum/momentum.c 's->viscosity / (g->d[c] * g->d[c])' \
  '(c == 1 ? 0.9 : 1) * s->viscosity / (g->d[c] * g->d[c])'
named "a smaller viscosity across the walls" fluid 1 stream "${walls[@]}"
seed fluid/measure/side_flux.c 'l->convection * l->sign * velocity * carried' \
  '0.5 * l->convection * l->sign * velocity * carried'
named "half of what is carried along an open side" fluid 1 stream "${open[@]}" "${oblique[@]}"
seed ibm/feedback.c 'fluid_diffusion_stage(ibm->fluid, s->r, dt)' 'fluid_diffusion_stage(ibm->fluid, s->r, 0.9 * dt)'
named "implicit diffusion over a part of the stage" fluid 1 stream "${implicit[@]}" "${walls[@]}"
seed fluid/momentum/kernels.c 'correct_row_in_place(g->m[0], c / g->d[d]' \
  'correct_row_in_place(g->m[0], 0.9 * c / g->d[d]' \
  'correct_row(g->m[0], c / g->d[d]' 'correct_row(g->m[0], 0.9 * c / g->d[d]'
named "a projection that goes nine tenths of the way" divergence 1 stream
seed cracks/leak_off.c 'b[i] -= c->leak[i]' 'b[i] += c->leak[i]'
named "leak-off with the wrong sign in the equation of the pressures" cracks 1 crack
seed cracks/leak_off.c 'c->content[i] -= c->leak[i]' 'c->content[i] -= 0.5 * c->leak[i]'
named "leak-off of which half stays" cracks 1 crack
seed cracks/project.c 'now = c->work->force[i] / s->volume[h]' 'now = 0.9 * c->work->force[i] / s->volume[h]'
named "a pressure in cracks that pushes less than it was found with" cracks 1 crack
seed cracks/project.c 'c->content[i] -= flow[i];
' 'c->content[i] -= 0.9 * flow[i];
'
named "a flow through pores of which a part is lost" cracks 1 pores
seed cracks/leak_off.c 'c->leak[i] = 2 * c->in' 'c->leak[i] = -2 * c->in'
named "leak-off that gives" leak 1 crack
seed cracks/kernel.c 'vec_store(force[c] + h.slot, f[c])' 'vec_store(force[c] + h.slot, 2 * f[c])'
named "pressures that push with twice the force" push 1 pores
seed cracks/kernel.c 'vec_store(volume + h.slot, sum)' 'vec_store(volume + h.slot, 2 * sum)'
named "cracks that open twice the volume" push 1 crack
seed fluid/momentum/momentum.c 's->viscosity / (g->d[c] * g->d[c])' \
  '(c == 1 ? 0.9 : 1) * s->viscosity / (g->d[c] * g->d[c])'
named "a smaller viscosity along one axis" flow 1 vortices
seed fluid/predict.c '.a = dt * f->scheme.alpha[r],' '.a = dt * f->scheme.alpha[r] * (r == 1 ? 0.9 : 1),'
named "a wrong coefficient of Runge and Kutta" flow 1 vortices
named "a wrong coefficient, in a channel" fluid 1 vortices "${walls[@]}" "${driven[@]}"
if thorough; then
  [ "$found" = 46 ] || fail "$found faults of 46"
  echo "$found faults are named"
  exit
fi

seed solid/step/verlet.c 'step = dt * (rate + 0.5 * dv);
        work' 'step = dt * (rate - 0.5 * dv);
        work' 's->e_damped += 0.5 * dt * (damped +' 's->e_damped -= 0.5 * dt * (damped +'
run_seeded 1 blocks "${damped[@]}"
for word in energy damping; do said "two faults in blocks" $word; done
seed coupling/load/reaction.c '0; h < r->solid->n; h++) r->solid->load[c][h] += r->reaction' \
  '0; h < r->solid->n; h++) r->solid->load[c][h] += 0.8 * r->reaction' '-by_drag / all : 0' '-0.5 * by_drag / all : 0'
also solid/force/drag.c '+= w->share[k] * impulse[c]' '+= 1.1 * w->share[k] * impulse[c]'
also coupling/load/inner_fluid.c 'coming - (1 - ahead) * a.gamma * gain' 'coming - (1 - ahead) * gain'
also ibm/feedback.c 'ibm->increment[h][c] = direct;' 'ibm->increment[h][c] = 1.5 * direct;'
also fluid/measure/box_couple.c 'arm[d] = g->length[d];' 'arm[d] = 0.1 * g->length[d];'
also fluid/momentum/kernels.c 'correct_row_in_place(g->m[0], c / g->d[d]' \
  'correct_row_in_place(g->m[0], 0.9 * c / g->d[d]'
run_seeded 1 stream --set stages.meet.steps=20 "${oblique[@]}"
for word in momentum adjoint reaction inner fluid angular divergence; do said "seven faults in a stream" $word; done
seed cracks/leak_off.c 'b[i] -= c->leak[i]' 'b[i] += c->leak[i]'
run_seeded 1 crack
said "a fault in cracks" cracks
seed cracks/leak_off.c 'c->leak[i] = 2 * c->in' 'c->leak[i] = -2 * c->in'
also cracks/kernel.c 'vec_store(force[c] + h.slot, f[c])' 'vec_store(force[c] + h.slot, 2 * f[c])'
run_seeded 1 crack
for word in leak push; do said "two more faults in cracks" $word; done
seed fluid/momentum/momentum.c 's->viscosity / (g->d[c] * g->d[c])' \
  '(c == 1 ? 0.9 : 1) * s->viscosity / (g->d[c] * g->d[c])'
run_seeded 1 vortices
said "a fault in a flow without bodies" flow
