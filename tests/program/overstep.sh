#!/usr/bin/env bash
# Given steps beyond the stable ones: frana check and the log of a run name the stage, the step and the limit.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
scene | sed 's/^coupling:/&\n  load: probe/' >block.yaml # the probe takes any number of substeps
# says COUNT [--set KEY=VALUE]...: frana check ends with 0 and has that many warnings, beside that of a small load
says() {
  local count=$1; shift
  code 0 ranks 1 check block.yaml "$@"
  [ "$(grep warning: out | grep -vc 'will not break')" = "$count" ] || { cat out >&2; fail "not $count warnings: $*"; }
}
has() { grep -qE "^  warning: $1\$" out || { cat out >&2; fail "check does not say: $1"; }; }

# 1.65 cell^2/(12 viscosity) = 3.35693e-4 s, given with five digits, and four substeps
says 0
# so short that nothing moves; and check says how many steps the flow needs
says 2 --set stages.flow.time_step=1e-12
has "stage flow: the step of 1e-12 s is 3e-09 of a stable one, 0\.0003357 s: nothing moves in 60 such steps"
# so short that no value changes: refused, by the run too; and steps that are lost in the rounding of the time
refused() { # SENTENCE [--set KEY=VALUE]...
  local sentence=$1; shift
  for command in check "run --out refused"; do
    # shellcheck disable=SC2086 # words
    code 2 ranks 1 $command block.yaml "$@"
    grep -qE "^frana: $sentence\$" err || { cat err >&2; fail "$command does not say: $sentence"; }
  done
  [ ! -e refused ] || fail "a refused run has a folder"
}
refused "stage flow: the step of 1e-30 s is 3e-27 of a stable one, 0\.0003357 s: no value .* changes in such a step" \
  --set stages.flow.time_step=1e-30
refused "stage settle: the step of 1e-21 s is .* of a stable one, .* s: no value .* changes in such a step" \
  --set stages.settle.time_step=1e-21
refused "stage flow: all its steps of 1e-18 s together are 1\.8e-13 of one .* s: nothing .* 5\.6e-15 s or more.*" \
  --set stages.flow.time_step=1e-18
refused "stage settle: the step of 1e-12 s is lost in the rounding of the time, .*: take 4e-12 s or more" \
  --set stages.flow.time_step=300 --set stages.settle.time_step=1e-12
# 1,860 times the fluid's viscous limit
says 1 --set stages.flow.time_step=0.62439
has "stage flow: the step of 0\.62439 s is 1860 times the fluid's viscous limit: at most 0\.00033569 s is stable"
# the convective limit: from the inflow's largest velocity, while the fluid is at rest
says 1 --set fluid.initial.velocity='[0, 0, 0]' --set fluid.viscosity=1e-6 --set stages.flow.time_step=1
has "stage flow: .* times the fluid's convective limit for the velocities .*: at most 0\.01[0-9]* s is stable"
# from a wall's velocity: 1.7321 x 1.5625e-3 m / (10 m/s), in another direction than the flow's
says 1 --set fluid.initial.velocity='[0, 0, 0]' --set fluid.viscosity=1e-4 --set stages.flow.time_step=0.1 \
  --set fluid.sides.y_high.velocity='[0, 0, 10]'
has "stage flow: .* times the fluid's convective limit .*: at most 0\.00027063 s is stable"
# from a held bulk velocity, twice it
says 1 --set fluid.initial.velocity='[0, 0, 0]' --set fluid.viscosity=1e-6 --set stages.flow.time_step=1 \
  --set fluid.sides.x_low='{type: periodic}' --set fluid.sides.x_high='{type: periodic}' \
  --set fluid.driving='{type: bulk_velocity, value: 0.2}'
has "stage flow: .* 73\.9 times the fluid's convective limit .*: at most 0\.013532 s is stable"
# implicit diffusion has no viscous limit
says 0 --set fluid.diffusion=implicit --set stages.flow.time_step=1e-2 --set stages.fracture.breakage=false
# the solid's own limit, with a given step and with an automatic one
says 1 --set stages.fracture.substeps=1
has "stage fracture: the solid's substep of 3\.3569e-05 s is [0-9.]* times its limit by damping: at most .*"
has "stage fracture: .*: at most 1\.1[0-9]*e-05 s is stable, which takes 4 substeps in a step"
says 1 --set stages.fracture.substeps=1 --set stages.fracture.time_step=auto
has "stage fracture: the solid's substep of up to 0\.00012[0-9]* s is [0-9.]* times its limit by damping: .*"
# the limit with contact, when a bond has broken: of RK3; velocity Verlet has none
says 0 --set stages.fracture.substeps=3
says 1 --set stages.fracture.integrator=rk3 --set stages.fracture.substeps=3
has "stage fracture: .* times its limit by contact, once a broken bond has closed: .* takes 4 substeps in a step"
# an automatic number of substeps is never too small; each stage and each part has its sentence
says 3 --set stages.flow.time_step=1 --set stages.fracture.time_step=1.0e-2
has "stage flow: .*viscous.*"
has "stage fracture: .*viscous.*"
has "stage fracture: .*damping.*"

# bonds that may break in a step of many stable ones of the solid, undamped, which is a sentence too, about as light as
# the fluid
long=(--set stages.fracture.damping_relative=0 --set stages.fracture.substeps=auto)
says 2 "${long[@]}"
has "stage fracture: bonds may break, and the step of 3\.36e-05 s is 2\.44 times the solid's stable step: about 5 % .*"
says 1 "${long[@]}" --set stages.fracture.time_step=auto # which is short enough
says 2 "${long[@]}" --set stages.fracture.time_step=3.0e-4
has "stage fracture: bonds may break, and the step of 0\.0003 s is 2[0-9.]* times the solid's stable step.*"
says 1 "${long[@]}" --set stages.fracture.time_step=3.0e-4 --set stages.fracture.breakage=false
says 0 "${long[@]}" --set stages.fracture.time_step=3.0e-4 --set fluid.density=1

# a run logs the same once, and runs
set=(--set stages.flow.steps=0 --set stages.settle.steps=0 --set stages.fracture.steps=0
  --set stages.flow.time_step=1 --set stages.fracture.substeps=1)
code 0 ranks 1 check block.yaml "${set[@]}"
sed -n 's/^  warning: //p' out >want
code 0 ranks 2 run block.yaml --out run --quiet "${set[@]}"
[ "$(wc -l <want)" = 2 ] || fail "$(wc -l <want) sentences, not 2"
while read -r line; do
  [ "$(grep -cF "warning: $line" run/run.log)" = 1 ] || fail "the log does not say once: $line"
done <want
# fewer substeps than an automatic number has: 2 with AB2; 6 with RK3 for less than 0.3 of the fluid's density
few() { # few COUNT [--set KEY=VALUE]...: check and the log of a run have that many such warnings, in the same words
  local count=$1; shift
  code 0 ranks 1 check "$source/tests/seeded/stream.yaml" --set stages.meet.steps=0 "$@"
  sed -n 's/^  warning: \(.* in a step .* fewer .*\)/\1/p' out >want
  [ "$(wc -l <want)" = "$count" ] || { cat out >&2; fail "not $count sentences on few substeps: $*"; }
  rm -rf light
  code 0 ranks 1 run "$source/tests/seeded/stream.yaml" --out light --quiet --set stages.meet.steps=0 "$@"
  [ "$(grep -c 'warning: .* in a step .* fewer' light/run.log)" = "$count" ] || fail "the log of $* says another number"
  while read -r line; do
    grep -qF "warning: $line" light/run.log || fail "the log does not say: $line"
  done <want
}
few 1 --set stages.meet.substeps=5
grep -q '^stage meet: 5 substeps in a step are fewer than 6, .* with fluid_integrator: rk3 and so light' want ||
  fail "the sentence is another one: $(cat want)"
few 0 --set stages.meet.substeps=6
few 0 --set stages.meet.substeps=3 --set solid.materials.0.density=0.4
few 1 --set stages.meet.substeps=1 --set stages.meet.fluid_integrator=ab2 --set solid.materials.0.density=3
grep -q '^stage meet: 1 substep in a step is fewer than 2, .* with fluid_integrator: ab2:' want ||
  fail "the sentence is another one: $(cat want)"
few 0 --set stages.meet.substeps=2 --set stages.meet.fluid_integrator=ab2
few 0
# a solid without a fluid
code 0 ranks 1 check "$source/cases/bar/scene.yaml" --set stages.pull.time_step=0.01 --set stages.pull.substeps=1
has "stage pull: the solid's substep of 0\.01 s is 1099 times its limit by bonds: at most 9\.09[0-9]*e-06 s is .*"
# a load by probes and bonds that nothing damps: the run is ruined within 100 steps; with the damping that is named the
# load stays that of a ball in a stream, 0.46 N
cat >held.yaml <<'YAML'
domain: {size: [2, 1, 1], cells: [32, 16, 16]}
fluid:
  density: 1
  viscosity: 0.05
  sides:
    {x_low: {type: inflow, bulk_velocity: 1}, x_high: {type: outflow}, y_low: {type: slip}, y_high: {type: slip},
     z_low: {type: slip}, z_high: {type: slip}}
solid:
  materials: [{name: s, youngs_modulus: 1000, density: 2}]
  bodies: [{name: ball, shape: sphere, centre: [0.7, 0.5, 0.5], radius: 0.25}]
  constraints: [{low: [0.65, 0.45, 0.45], high: [0.75, 0.55, 0.55], velocity: [0, 0, 0]}]
coupling: {load: probe}
stages: 
  - {name: free, steps: 200}
output: {fields_every: 0, checkpoint_every: 0, series_every: 1}
YAML
code 0 ranks 1 check held.yaml
said="warning: stage free: with coupling.load: probe nothing damps"
damping=$(sed -n "s/^  $said .* damping_relative: \([0-9.e+]*\) .*/\1/p" out)
[ -n "$damping" ] || { cat out >&2; fail "check does not say that nothing damps the bonds"; }
code 0 ranks 1 run held.yaml --out held --quiet --set stages.free.damping_relative="$damping"
! grep "nothing damps" held/run.log || fail "said of bonds that are damped"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } END { exit !($at["load_x"] > 0.4 && $at["load_x"] < 0.55) }' \
  held/series.csv || fail "a load of other than 0.46 N: $(tail -n 1 held/series.csv)"
code 0 ranks 1 run held.yaml --out undamped --quiet --set stages.free.steps=2
grep -q "$said" undamped/run.log || fail "the log does not say it"
code 3 ranks 1 run held.yaml --out ruined --quiet
grep -q "^the energy balance is broken in step .* by probes the fluid has got" ruined/run.log ||
  fail "another end: $(tail -n 2 ruined/run.log)"
code 0 ranks 1 check held.yaml --set coupling.load=reaction
! grep "nothing damps" out || fail "said of the load by reaction"
echo "every limit is named"
