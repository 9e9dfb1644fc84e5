#!/usr/bin/env bash
# frana check names each size that is too few spacings or horizons, and is silent where all are large enough.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >plate.yaml <<'SCENE'
title: Few spacings
domain: {size: [0.3, 0.1]}
solid:
  spacing: 1.0e-3
  model: plane_stress
  materials:
    - name: rock
      youngs_modulus: 15.0e9
      density: 2200
      fracture_energy: 30
      breakage: {law: bilinear, tensile_strength: 4.0e6}
  bodies:
    - {shape: rectangle, low: [0, 0], high: [0.1, 0.004]}
    - {shape: disc, centre: [0.25, 0.05], radius: 0.02, holes: [{shape: disc, centre: [0.25, 0.05], radius: 0.005}]}
  cracks:
    - points: [[0, 0.002], [0.009, 0.002]]
stages:
  - {name: pull, steps: 10, integrator: verlet}
SCENE
says() { grep -qF "$1" out || { cat out >&2; fail "not said: $1"; }; }
code 0 ranks 1 check plate.yaml
says "solid.bodies[0].high: 4 spacings thick along y, 6 are asked for: too soft in bending by 3 to 10 %"
says "solid.bodies[1].holes[0].radius: a radius of 5 spacings, 16 are asked for: the stress at its edge is"
says "solid.bodies[1].radius: 20 spacings, 24 are asked for where bodies collide: along a lattice axis the"
says "collision is 21 to 30 % too short"
says "solid.cracks[0].points: 3 horizons long, 4 are asked for: the crack starts at up to 1.4 times Griffith's load"
says "solid.materials[0].breakage.tensile_strength: the horizon is 0.107 E G0/sigma_t2, at least 0.25 are asked for"
[ "$(sed -n '/^few spacings/,$p' out | grep -c .)" = 6 ] || fail "other sentences: $(sed -n '/^few spacings/,$p' out)"
code 0 ranks 1 check plate.yaml --set 'solid.materials[0].breakage.tensile_strength=12.0e6'
says "the horizon is 0.96 E G0/sigma_t2, at most 0.8 are asked for: the law is nearly brittle"
# on the bounds, or without what they are for: nothing is said
sed -e 's/0.004\]/0.006]/; s/radius: 0.02,/radius: 0.024,/; s/radius: 0.005/radius: 0.016/' \
  -e 's/0.009, 0.002/0.012, 0.002/; s/strength: 4.0e6/strength: 9.0e6/' plate.yaml >enough.yaml
code 0 ranks 2 check enough.yaml
! grep -q 'few spacings' out || fail "said of sizes that are large enough: $(sed -n '/^few spacings/,$p' out)"
code 0 ranks 1 check enough.yaml --set 'solid.materials[0].poisson_ratio=-0.2'
says "solid.materials[0].poisson_ratio: -0.2 is negative: parts six spacings thick are 10 % too stiff in tension"
code 0 ranks 1 check plate.yaml --set solid.contact.enabled=false --set 'stages.pull.breakage=false'
[ "$(sed -n '/^few spacings/,$p' out | grep -c .)" = 3 ] || fail "not a wall and a hole: $(sed -n '/^few/,$p' out)"

cat >space.yaml <<'SCENE'
title: Walls in space
domain: {size: [0.02, 0.02, 0.008], periodic: [false, false, true]}
solid:
  spacing: 1.0e-3
  materials:
    - {name: rock, youngs_modulus: 15.0e9, density: 2200, fracture_energy: 30}
  bodies:
    - shape: box
      low: [0, 0, 0]
      high: [0.02, 0.003, 0.008]
      cavities: {period: 0.01, radius: 0.001, centre: [0, 0, 0]}
  cracks:
    - points: [[0, 0.0015, 0], [0.018, 0.0015, 0], [0.018, 0.0015, 0.005], [0, 0.0015, 0.005]]
stages:
  - {name: pull, steps: 10, integrator: verlet}
SCENE
code 0 ranks 1 check space.yaml
says "solid.bodies[0].high: 3 spacings thick along y, 6 are asked for: too soft in bending by 10 to 26 %"
says "solid.bodies[0].cavities.radius: a radius of 1 spacings, 16 are asked for"
says "solid.cracks[0].points: 1.66667 horizons long, 4 are asked for: the crack starts at more than 1.4 times"
code 2 ranks 1 check space.yaml --set solid.spacing=1e-9
grep -q '^frana: solid.spacing = 1e-09 m: the body .* reaches from 0 to 0.02 m along x; it may be 1e+06 spacings' err ||
  fail "not said how small the spacing may be: $(cat err)"
code 0 ranks 1 check space.yaml --set 'solid.bodies[0].high=[0.02, 0.006, 0.008]'
! grep -q 'thick along' out || fail "the period is taken for a wall's thickness"
# a layer between its held end and a loaded face: loads of the scene and of a flow; not a slender one, not a deep one
cat >layer.yaml <<'SCENE'
title: A layer
domain: {size: [0.012, 0.04, 0.012], periodic: [true, false, true]}
solid:
  spacing: 1.0e-3
  materials: [{name: soft, youngs_modulus: 1.0e5, density: 1000}]
  bodies: [{shape: box, low: [0, 0, 0], high: [0.012, 0.015, 0.012]}]
  constraints: [{low: [0, 0, 0], high: [0.012, 0.003, 0.012]}]
  loads: [{low: [0, 0.014, 0], high: [0.012, 0.015, 0.012], force: [1.0e3, 0, 0]}]
stages: [{name: go, steps: 10}]
SCENE
code 0 ranks 1 check layer.yaml
says "solid.bodies[0]: 12 spacings along y from its held end to its face, 24 are asked for: a load on its last layer"
says "moves this face about 14 % too far by pressure and 7.7 % by shear"
silent_of_layers() {
  code 0 ranks 1 check layer.yaml "$@"
  ! grep -q 'from its held end' out || fail "said without reason: $(grep 'held end' out) $*"
}
silent_of_layers --set 'solid.loads[0].low=[0, 0.012, 0]'
silent_of_layers --set 'solid.bodies[0].high=[0.004, 0.015, 0.012]'
silent_of_layers --set 'solid.bodies[0].high=[0.012, 0.027, 0.012]' --set 'solid.loads[0].low=[0, 0.026, 0]' \
  --set 'solid.loads[0].high=[0.012, 0.027, 0.012]'
silent_of_layers --set solid.surface_correction=none
sed -e 's/, periodic: .*/, cells: [12, 40, 12]}/' -e '/spacing:/d; /loads:/d' layer.yaml >wet.yaml
cat >>wet.yaml <<'SCENE'
fluid: {density: 1000, viscosity: 1.0e-5, sides: {x_low: {type: periodic}, x_high: {type: periodic},
    y_low: {type: wall}, y_high: {type: wall}, z_low: {type: periodic}, z_high: {type: periodic}}}
SCENE
code 0 ranks 1 check wet.yaml
says "12 spacings along y from its held end to its face, 24 are asked for: the flow moves this face about 18 % too far"
code 0 ranks 1 check wet.yaml --set 'solid.constraints=[{low: [0, 0, 0], high: [0.012, 0.015, 0.012]}]'
! grep -q 'from its held end' out || fail "said of a body that is held as a whole"
# a ball between plates: thrown, it collides; pressed slowly, its facet is named too, unless it has none
cat >ball.yaml <<'SCENE'
title: A ball on a plate
domain: {size: [0.04, 0.04, 0.04]}
solid:
  spacing: 1.0e-3
  materials: [{name: one, youngs_modulus: 1.0e6, density: 1000}]
  bodies:
    - {name: low, shape: box, low: [0.014, 0.014, 0.002], high: [0.026, 0.026, 0.008]}
    - {name: ball, shape: sphere, centre: [0.020, 0.020, 0.016], radius: 0.008}
  constraints: [{low: [0.014, 0.014, 0.002], high: [0.026, 0.026, 0.008], displacement: [0, 0, 1.0e-3]}]
stages: [{name: squeeze, steps: 1, relax: true}]
SCENE
facet="solid.bodies[1].radius: a round body on the lattice ends in a flat facet along each axis: pressed in by 1/4, 1/2"
code 0 ranks 1 check ball.yaml
says "$facet and 1 spacing it bears 2.6, 1.8 and 1.2 times Hertz's force there"
no_facet() {
  code 0 ranks 1 check ball.yaml "$@"
  ! grep -q facet out || fail "a facet without reason: $*"
}
no_facet --set 'stages=[{name: go, steps: 1}]'
# at twice the spacing, where points that are perturbed do not take seconds
code 0 ranks 1 check ball.yaml --set solid.spacing=2.0e-3
says "$facet"
no_facet --set solid.spacing=2.0e-3 --set 'solid.bodies.ball.arrangement={kind: perturbed, perturbation: 0.2}'
no_facet --set 'solid.bodies=[{shape: sphere, centre: [0.02, 0.02, 0.016], radius: 0.008}]' --set 'solid.constraints=[]'
# a porous square with free faces, and one that is wide enough
cat >porous.yaml <<'SCENE'
title: A porous square
domain: {size: [0.08, 0.08]}
solid:
  spacing: 1.0e-3
  model: plane_strain
  materials: [{name: rock, youngs_modulus: 2.0e10, density: 2500}]
  bodies: [{shape: rectangle, low: [0.004, 0.004], high: [0.028, 0.064]}]
crack_fluid:
  viscosity: 1.0e-3
  least_aperture: 1.0e-8
  least_pressure: -1.0e9
  pores: {permeability: 1.0e-19, biot: 0.8, modulus: 4.0e10}
  injections: [{low: [0.014, 0.014], high: [0.018, 0.018], rate: 0}]
stages: [{name: go, steps: 10, crack_fluid: true}]
SCENE
code 0 ranks 1 check porous.yaml
says "solid.bodies[0]: 24 spacings across, 60 are asked for with pores: sealed and under a stress from all sides its"
says "pressure is about 5 % too high in the middle"
code 0 ranks 1 check porous.yaml --set 'solid.bodies[0].high=[0.064, 0.064]'
! grep -q 'with pores' out || fail "said of a body that is wide enough"
code 0 ranks 1 check porous.yaml --set 'domain={size: [0.024, 0.08], periodic: [true, false]}' \
  --set 'solid.bodies[0].low=[0, 0.004]' --set 'solid.bodies[0].high=[0.024, 0.064]'
! grep -q 'with pores' out || fail "said of a layer"
# a body close before a side through which the flow leaves
cat >outlet.yaml <<'SCENE'
title: A sphere in a channel
domain: {size: [0.06, 0.02, 0.02], cells: [48, 16, 16]}
fluid:
  density: 1000
  viscosity: 1.0e-5
  sides: {x_low: {type: inflow, bulk_velocity: 1.0e-3}, x_high: {type: outflow}, y_low: {type: slip},
    y_high: {type: slip}, z_low: {type: periodic}, z_high: {type: periodic}}
solid:
  materials: [{name: m, youngs_modulus: 1.0e5, density: 1000}]
  bodies: [{name: ball, shape: sphere, centre: [0.055, 0.01, 0.01], radius: 0.003}]
stages: [{name: flow, steps: 1, solid: rigid}]
SCENE
code 0 ranks 2 check outlet.yaml
says "warning: body ball stands 0.0025 m before the open side x_high, less than its radius: the load on it is too small"
code 0 ranks 1 check outlet.yaml --set 'solid.bodies.ball.centre=[0.045, 0.01, 0.01]'
! grep -q 'open side' out || fail "said of a body that is far from the side"
code 0 ranks 1 check outlet.yaml --set 'solid.bodies.ball={shape: box, low: [0.04, 0, 0], high: [0.07, 0.02, 0.02]}'
! grep -Eq 'open side|on the outflow' out || fail "said of a sample that the side cuts"
block='low: [0.05, 0.005, 0.005], high: [0.06, 0.015, 0.015]'
code 0 ranks 1 check outlet.yaml --set "solid.bodies.ball={name: ball, shape: box, $block}"
says "warning: body ball ends on the outflow x_high: the load on it is wrong and may point upstream"
# a sphere that starts from rest, with a viscous layer below a cell and above one
cat >start.yaml <<'SCENE'
title: A sphere in a fluid at rest
domain: {size: [0.02, 0.02, 0.02], cells: [16, 16, 16]}
fluid: {density: 1000, viscosity: 1.0e-6, sides: {x_low: {type: slip}, x_high: {type: slip}, y_low: {type: slip},
    y_high: {type: slip}, z_low: {type: slip}, z_high: {type: slip}}}
solid:
  materials: [{name: m, youngs_modulus: 1.0e5, density: 1000}]
  bodies: [{name: ball, shape: sphere, centre: [0.01, 0.01, 0.01], radius: 0.005}]
stages: [{name: fall, steps: 10, time_step: 1.0e-3}]
SCENE
code 0 ranks 1 check start.yaml
says "solid.bodies[0].radius: 8 cells in a diameter, and a viscous layer sqrt(nu t) of 0.08 cells at the run's end"
code 0 ranks 1 check start.yaml --set fluid.viscosity=2.0e-4 --set stages.fall.time_step=auto --set stages.fall.steps=40
! grep -q 'viscous layer' out || fail "said of a layer that is resolved"
echo ok

# gaps of the fluid: two cells between two bodies that fill the period, across the border of two words of cells
cat >gaps.yaml <<'SCENE'
title: Bodies with a gap
domain: {size: [0.07, 0.008, 0.008], cells: [70, 8, 8]}
fluid:
  density: 1000
  viscosity: 1.0e-6
  sides:
    {x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: periodic}, y_high: {type: periodic},
     z_low: {type: periodic}, z_high: {type: periodic}}
solid:
  materials: [{name: rock, youngs_modulus: 1.0e7, density: 2000}]
  bodies:
    - {name: a, shape: box, low: [0.020, 0, 0], high: [0.062, 0.008, 0.008]}
    - {name: b, shape: box, low: [0.064, 0, 0], high: [0.070, 0.008, 0.008]}
stages: [{name: go, steps: 10, solid: rigid}]
SCENE
gaps() { # share, of the scene with these keys
  local share=$1; shift
  code 0 ranks "${n:-1}" check gaps.yaml "$@"
  if [ -z "$share" ]; then
    ! grep -q '^few cells' out || fail "said of wide gaps: $(sed -n '/^few cells/,$p' out)"
  else
    says "domain.cells: $share % of the fluid beside the solid is in gaps of less than 3 cells, six are asked for"
  fi
}
gaps 50
n=2 gaps 50
gaps '' --set 'solid.bodies.b.low=[0.065, 0, 0]'
walls=(--set fluid.sides.x_low.type=wall --set fluid.sides.x_high.type=wall)
gaps 75 "${walls[@]}" --set 'solid.bodies.b.high=[0.069, 0.008, 0.008]' # a film before a wall
gaps 50 --set 'solid.bodies.b.high=[0.069, 0.008, 0.008]'               # open across the period
# nine ducts of one cell along x, and a ball
ducts=
for y in 1 5 9; do
  for z in 1 5 9; do
    ducts+="{shape: box, low: [0, ${y}.0e-3, ${z}.0e-3], high: [0.024, $((y + 1)).0e-3, $((z + 1)).0e-3]},"
  done
done
gaps 34.8 --set 'domain={size: [0.024, 0.012, 0.012], cells: [24, 12, 12]}' \
  --set "solid.bodies=[{shape: box, low: [0.004, 0, 0], high: [0.020, 0.012, 0.012], holes: [$ducts]}]"
gaps '' --set 'solid.bodies=[{shape: sphere, centre: [0.03, 0.004, 0.004], radius: 0.0025}]'
