#!/usr/bin/env bash
# frana check compares the load with the strength: bars whose sections have known stresses, a crack, prescribed motions,
# a flow; and what it says of a bar agrees with the most stretched bond of a run.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >bar.yaml <<'SCENE'
title: A bar held at one end
domain: {size: [0.1, 0.02, 0.02]}
solid:
  spacing: 1.0e-3
  materials: [{name: rock, youngs_modulus: 1.0e9, density: 2000, fracture_energy: 1}]
  bodies: [{name: bar, shape: box, low: [0, 0, 0], high: [0.06, 0.01, 0.01]}]
  constraints: [{low: [0, 0, 0], high: [0.003, 0.01, 0.01], directions: xyz}]
  loads: [{low: [0.059, 0, 0], high: [0.06, 0.01, 0.01], force: [1.0e6, 0, 0]}]
stages:
  - {name: pull, steps: 1, relax: true, breakage: false}
  - {name: free, steps: 1}
output: {fields_every: 0, checkpoint_every: 0}
SCENE
# stress NAME: what check estimated for a body, Pa
stress() { sed -n "s/^  $1: a stress of about \([-+0-9.e]*\) Pa.*/\1/p" out; }
# near WHAT GOT WANTED LOW HIGH: GOT/WANTED lies between LOW and HIGH
near() {
  awk -v g="$2" -v w="$3" -v l="$4" -v h="$5" 'BEGIN { exit !(g / w >= l && g / w <= h) }' || fail "$1: $2, not $3"
}
# 0.1 N along the bar over 1e-4 m2
for n in 1 2; do
  code 0 ranks $n check bar.yaml
  near "pulled on $n ranks" "$(stress bar)" 1e3 0.999 1.001
  grep -q 'warning: bar will not break: its loads are 527 times too small' out || fail "not said that nothing breaks"
done
# runs have twice the spacing, a layer that is held and one that is pulled
coarse=(--set solid.spacing=2.0e-3 --set 'solid.constraints[0].high=[0.004, 0.01, 0.01]'
  --set 'solid.loads[0].low=[0.058, 0, 0]')
code 0 ranks 1 run bar.yaml --out pulled "${coarse[@]}" --set 'solid.loads[0].force=[5.0e5, 0, 0]'
most=$(sed -n 's/.*a stress of about \([0-9.e+]*\) of.*/\1/p' out | tail -n 1)
near "the most stretched bond of the pulled bar" "$most" 1e3 1 2.5
# beside an idle body of a weak material and one that never breaks: each bond has its own limit
part() { sed -n 's/.*most stretched one is at \([0-9.e-]*\) of.*/\1/p' out | tail -n 1; }
alone=$(part)
code 0 ranks 1 run bar.yaml --out hybrid "${coarse[@]}" --set 'solid.loads[0].force=[5.0e5, 0, 0]' \
  --set 'solid.materials=[
  {name: rock, youngs_modulus: 1.0e9, density: 2000, fracture_energy: 1},
  {name: weak, youngs_modulus: 1.0e8, density: 2000, fracture_energy: 1.0e-3},
  {name: steel, youngs_modulus: 1.0e9, density: 2000}]' --set 'solid.bodies=[
  {name: bar, material: rock, shape: box, low: [0, 0, 0], high: [0.06, 0.01, 0.01]},
  {name: idle, material: weak, shape: box, low: [0, 0.015, 0], high: [0.02, 0.02, 0.01]},
  {name: hard, material: steel, shape: box, low: [0.03, 0.015, 0], high: [0.05, 0.02, 0.01]}]'
near "beside other materials" "$(part)" "$alone" 1 1
# 1000 times the load: beyond the limit, but no bond may break before the second stage
code 0 ranks 2 run bar.yaml --out beyond "${coarse[@]}" --set 'solid.loads[0].force=[5.0e8, 0, 0]'
grep -Eq 'warning: stage pull: [0-9]+ bonds are stretched beyond their critical stretch.*once when stage free' out ||
  fail "not said that bonds will break at once"
code 0 ranks 1 run bar.yaml --out whole "${coarse[@]}" --set 'solid.loads[0].force=[5.0e8, 0, 0]' \
  --set 'solid.unbreakable=[{low: [0, 0, 0], high: [0.1, 0.02, 0.02]}]'
! grep -q 'bonds are stretched beyond' out || fail "unbreakable bonds are said to break"
# across it: M = 0.1 N 0.056 m in the first free layer, M/W = 33600 Pa with W = h^3/6, and 1500 Pa of shear
code 0 ranks 1 check bar.yaml --set 'solid.loads[0].force=[0, 1.0e6, 0]'
near bent "$(stress bar)" 33667 0.999 1.001
code 0 ranks 1 run bar.yaml --out bent "${coarse[@]}" --set 'solid.loads[0].force=[0, 5.0e5, 0]'
most=$(sed -n 's/.*a stress of about \([0-9.e+]*\) of.*/\1/p' out | tail -n 1)
near "the most stretched bond of the bent bar" "$most" 33667 0.7 1.5
# its own weight: M = rho g A L^2/2 over the 57 free layers, counted from the middle of the first
code 0 ranks 1 check bar.yaml --set 'solid.loads=[]' --set 'solid.body_force=[0, -10, 0]'
near "its weight" "$(stress bar)" "$(awk 'BEGIN { l = 0.0565; n = 3 * 2000 * 10 * l * l / 0.01; t = 1.5 * 2e4 * l
  print n / 2 + sqrt(n * n / 4 + t * t) }')" 0.99 1.01
# not held: the pulled bar accelerates, and its middle carries half of the force; the end nearly all of it
code 0 ranks 1 check bar.yaml --set 'solid.constraints=[]'
near free "$(stress bar)" 1e3 0.95 1
# pressed: Griffith's eighth
code 0 ranks 1 check bar.yaml --set 'solid.loads[0].force=[-1.0e6, 0, 0]'
near pressed "$(stress bar)" 125 0.999 1.001
# a factor of time that is largest within the run, a load that never comes, one that fades while nothing moves yet
code 0 ranks 1 check bar.yaml --set 'solid.loads[0].time=[[0, 0], [1.0e-9, 3]]'
near "a ramp" "$(stress bar)" 3e3 0.999 1.001
code 0 ranks 1 check bar.yaml --set 'solid.loads[0].time=[[1, 0], [2, 3]]'
grep -q 'bar: no load that can be foreseen' out || fail "a load after the run's end counts"
grep -q 'warning: solid.loads\[0\].time: the run ends at t = ' out || fail "check is silent on a load that never comes"
# a tenth of a ramp, in a stage of 1 ms after one of 10 ms, from whose start the times count
late=(--set 'stages=[{name: wait, duration: 1.0e-2, steps: 100000},
  {name: pull, duration: 1.0e-3, steps: 100000}]')
code 0 ranks 1 check bar.yaml "${late[@]}" --set 'solid.loads[0].time=[[0, 0], [1.0e-2, 3]]' \
  --set 'solid.loads[0].time_from=pull'
near "a tenth of a ramp" "$(stress bar)" 300 0.999 1.001
grep -q 'the factor changes until 0.01 s after the start of stage pull, which lasts 0.001 s' out ||
  fail "check does not say that the ramp is too long"
# a velocity of 0.01 m/s that begins then: E times 1e-5 m over the 0.057 m between the layers
code 0 ranks 1 check bar.yaml "${late[@]}" --set 'solid.loads=[]' --set 'solid.constraints=[
  {low: [0, 0, 0], high: [0.003, 0.01, 0.01]}, {low: [0.057, 0, 0], high: [0.06, 0.01, 0.01], directions: x,
  velocity: [0.01, 0, 0], time: [[0, 0], [1.0e-9, 1]], time_from: pull}]'
near "a velocity from a stage on" "$(stress bar)" 1.754e5 0.99 1.01
# both ends moved: E times the strain between the middles of the two layers
code 0 ranks 1 check bar.yaml --set 'solid.loads=[]' --set 'solid.constraints=[
  {low: [0, 0, 0], high: [0.003, 0.01, 0.01],
  directions: xyz}, {low: [0.057, 0, 0], high: [0.06, 0.01, 0.01], directions: x, displacement: [5.7e-6, 0, 0]}]'
near moved "$(stress bar)" 1e5 0.999 1.001
grep -q 'by prescribed motions' out || fail "not said that motions are prescribed"

# Across a periodic side: as beside it. It goes on across it: each half carries half of the pull, and the bar bends as
# one between two clamped ends, F L/8 at the load and at the held layer, with a shear of F/2.
across=(--set domain.periodic='[true, false, false]' --set domain.size='[0.06, 0.02, 0.02]' --set solid.constraints=[])
beside=(--set 'solid.bodies[0].low=[0.01, 0, 0]' --set 'solid.bodies[0].high=[0.05, 0.01, 0.01]'
  --set 'solid.loads[0].low=[0.045, 0, 0]' --set 'solid.loads[0].high=[0.046, 0.01, 0.01]')
moved=(--set 'solid.bodies[0].low=[0.04, 0, 0]' --set 'solid.bodies[0].high=[0.08, 0.01, 0.01]'
  --set 'solid.loads[0].low=[0.015, 0, 0]' --set 'solid.loads[0].high=[0.016, 0.01, 0.01]')
for force in '[1.0e6, 0, 0]' '[0, 1.0e6, 0]'; do
  code 0 ranks 1 check bar.yaml "${across[@]}" "${beside[@]}" --set "solid.loads[0].force=$force"
  wanted=$(stress bar)
  code 0 ranks 2 check bar.yaml "${across[@]}" "${moved[@]}" --set "solid.loads[0].force=$force"
  near "across a side, pulled by $force" "$(stress bar)" "$wanted" 1 1
done
ring=("${across[@]}" --set 'solid.constraints=[{low: [0, 0, 0], high: [0.001, 0.01, 0.01], directions: xyz}]'
  --set 'solid.loads[0].low=[0.03, 0, 0]' --set 'solid.loads[0].high=[0.031, 0.01, 0.01]')
code 0 ranks 2 check bar.yaml "${ring[@]}"
near "endless, pulled" "$(stress bar)" 500 0.999 1.001
code 0 ranks 1 check bar.yaml "${ring[@]}" --set 'solid.loads[0].force=[0, 1.0e6, 0]'
near "endless, bent" "$(stress bar)" "$(awk 'BEGIN { n = 0.1 * 0.06 / 8 / (1e-6 / 6); t = 1.5 * 500
  print n / 2 + sqrt(n * n / 4 + t * t) }')" 0.97 1.01

cat >plate.yaml <<'SCENE'
title: A plate with a crack
domain: {size: [0.1, 0.1]}
solid:
  spacing: 1.0e-3
  model: plane_stress
  materials: [{name: glass, youngs_modulus: 7.0e10, density: 2400, fracture_energy: 8}]
  bodies: [{name: plate, shape: rectangle, low: [0, 0], high: [0.1, 0.1]}]
  cracks: [{points: [[0.04, 0.05], [0.06, 0.05]]}]
  loads:
    - {edge: {from: [0, 0.1], to: [0.1, 0.1]}, traction: [0, 1.0e6]}
    - {edge: {from: [0, 0], to: [0.1, 0]}, traction: [0, -1.0e6]}
stages: [{name: pull, steps: 10}]
SCENE
code 0 ranks 1 check plate.yaml # sqrt(E G0/(pi a)), a = 0.01 m
near "a plate's tension" "$(stress plate)" 1e6 0.999 1.001
griffith() { sed -n 's/.*breaks at \([0-9.e+]*\) Pa (Griffith.*/\1/p' out; }
near Griffith "$(griffith)" 4.2221e6 0.999 1.001
code 0 ranks 1 check plate.yaml --set 'solid.cracks[0].points=[[0, 0.05], [0.02, 0.05]]'
# an edge crack of 0.02 m
near "an edge crack" "$(griffith)" 2.6656e6 0.998 1.002 # three digits are printed
code 0 ranks 1 check plate.yaml --set stages.pull.breakage=false
! grep -q '^strength' out || fail "strength is compared where nothing breaks"

# A porous block in a flow: 3.5 N and 3.0e4 Pa were measured (drop times section; the most stretched bond at rest).
code 0 ranks 1 check "$source/cases/porous_channel/demo.yaml"
near "the demo's force" "$(sed -n 's/.*flow: about \([0-9.e+]*\) N.*/\1/p' out)" 3.5 0.5 2
near "the demo's stress" "$(stress block)" 3.04e4 0.2 5
# between pressures: 400 Pa over 0.05 m x 0.05 m
code 0 ranks 1 check "$source/cases/porous_channel/demo.yaml" \
  --set 'fluid.sides.x_low={type: pressure, pressure: 4000}' \
  --set 'fluid.sides.x_high={type: pressure, pressure: 0}' --set 'fluid.initial.velocity=[0, 0, 0]'
near "a drop's force" "$(sed -n 's/.*flow: about \([0-9.e+]*\) N.*/\1/p' out)" 10 0.999 1.001
! grep -q 'differences of pressure' out || fail "a level of 4000 Pa is of no account, and said"
# a level of the pressure is no load on bodies: 3 p/(E/(1 - 2 nu)) of their volume is missed
code 0 ranks 1 check "$source/cases/porous_channel/demo.yaml" \
  --set 'fluid.sides.x_low={type: pressure, pressure: 4.0e6}' \
  --set 'fluid.sides.x_high={type: pressure, pressure: 4.0e6}' --set 'fluid.initial.velocity=[0, 0, 0]'
grep -q "one of 4e+06 Pa all around would shrink them by 6 % in volume" out ||
  fail "the level of the pressure is not said"
echo ok
