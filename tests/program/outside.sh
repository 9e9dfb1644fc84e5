#!/usr/bin/env bash
# Particles of a file beyond the domain: those beyond a periodic side come in at the opposite one, others are counted
# and said with the line of the first; a file of which none is inside is refused.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# bar FILE [DX [FROM]]: 16 x 4 x 4 particles 1 mm apart, from the FROM-th layer on moved by DX m; line 1 is a comment
bar() {
  awk -v dx="${2:-0}" -v from="${3:-0}" 'BEGIN {
    print "# x y z volume"
    for (i = 0; i < 16; i++) for (j = 0; j < 4; j++) for (k = 0; k < 4; k++)
      printf "%.17g %.17g %.17g 1e-9\n", (i + 0.5) * 1e-3 + (i >= from ? dx : 0), (j + 0.5) * 1e-3, (k + 0.5) * 1e-3
  }' >"$1"
}
cat >scene.yaml <<'YAML'
title: A bar of points
domain: {size: [0.016, 0.004, 0.004]}
solid:
  spacing: 1.0e-3
  materials: [{name: any, youngs_modulus: 1.0e8, density: 3000, horizon_ratio: 2}]
  bodies: [{name: bar, shape: points, file: bar.txt}]
stages: [{name: rest, steps: 2, time_step: 1.0e-6}]
output: {series_every: 1, fields_every: 0, checkpoint_every: 0}
YAML
bonds() { sed -n 's/^  solid .* m apart, \([0-9]*\) bonds$/\1/p' out; }
periodic=(--set 'domain.periodic=[true, false, false]')

bar bar.txt
code 0 ranks 1 check scene.yaml
! grep -q outside out || fail "said of a bar in the domain"
open=$(bonds)
code 0 ranks 1 check scene.yaml "${periodic[@]}"
ring=$(bonds)
[ "$ring" -gt "$open" ] || fail "$ring bonds of a ring, $open of a bar"

# the second half is three periods further on
bar bar.txt 0.048 8
code 0 ranks 1 check scene.yaml "${periodic[@]}"
[ "$(bonds)" = "$ring" ] || fail "beyond a periodic side: $(bonds) bonds, not $ring"
! grep -q outside out || fail "said of points beyond a periodic side"
code 0 ranks 2 check scene.yaml
says='warning: 128 of the 256 particles of bar lie outside the domain, the first in line 130 of its file at '
says+='(0.0565, 0.0005, 0.0005) m: the sides of the domain do not stop particles'
grep -qxF "  $says" out || { cat out; fail "not said by frana check: $says"; }
code 0 ranks 2 run scene.yaml --out half
grep -qF "$says" half/run.log || { cat half/run.log; fail "not said by frana run: $says"; }
# in a flow
sed -e 's/domain: .*/domain: {size: [0.016, 0.008, 0.008], cells: [16, 8, 8]}/' -e '/^solid/i\
fluid:\
  density: 1000\
  viscosity: 1.0e-3\
  sides:\
    {x_low: {type: wall}, x_high: {type: wall}, y_low: {type: wall}, y_high: {type: wall},\
     z_low: {type: wall}, z_high: {type: wall}}
' scene.yaml >flow.yaml
code 0 ranks 1 check flow.yaml
grep -q 'm: the fluid exerts no force on them, nor they on it$' out || { cat out; fail "not said in a flow"; }

# none is inside: a file in mm
awk '/^#/ { print; next } { print 1000 * $1, 1000 * $2, 1000 * $3, $4 }' bar.txt >mm && mv mm bar.txt
code 2 ranks 2 run scene.yaml --out never
says='bar.txt: all of the 256 particles lie outside the domain, the first at x = 0.5 m, y = 0.5 m: are they in m?'
grep -qF "$says" err || { cat err; fail "a file in mm"; }
[ ! -e never ] || fail "a refused run leaves a folder"

# one particle far away takes no memory; one too far is refused
bar bar.txt
echo 3e4 3e4 3e4 1e-9 >>bar.txt
code 0 ranks 1 check scene.yaml
[ "$(bonds)" = "$open" ] || fail "with a particle far away: $(bonds) bonds, not $open"
says='warning: 1 of the 257 particles of bar lie outside the domain, the first in line 258'
grep -q "$says" out || fail "one far away"
awk '/in all/ { exit !($3 < 100) }' out || { cat out; fail "a particle far away takes memory"; }
sed -i '$s/^3e4/1e7/' bar.txt
code 2 ranks 1 check scene.yaml
grep -qF 'bar.txt: line 258: x = 1e+07 m is more than 1e+09 spacings from 0 (solid.spacing = 0.001 m)' err ||
  { cat err; fail "one too far away"; }

# a ball that leaves through an outflow: said once it is outside, and not while it is inside
cat >ball.yaml <<'SCENE'
title: A ball that leaves
domain: {size: [0.06, 0.03, 0.03], cells: [30, 15, 15]}
fluid:
  density: 1000
  viscosity: 1.0e-5
  initial: {velocity: [0.1, 0, 0]}
  sides:
    x_low: {type: inflow, profile: uniform, bulk_velocity: 0.1}
    x_high: {type: outflow}
    y_low: {type: slip}
    y_high: {type: slip}
    z_low: {type: slip}
    z_high: {type: slip}
solid:
  materials: [{name: soft, youngs_modulus: 1.0e5, density: 2000}]
  bodies: [{shape: sphere, centre: [0.045, 0.0151, 0.0147], radius: 0.0062, velocity: [0.5, 0, 0]}]
stages:
  - {name: inside, steps: 50, time_step: 2.0e-4}
  - {name: crosses, steps: 200, time_step: 2.0e-4}
output: {fields_every: 0, series_every: 10, checkpoint_every: 0}
SCENE
code 0 ranks "$(by_day 1 2)" run ball.yaml --out ball
says='stage crosses: [0-9]* particles have left through the outflow x_high: .* its momentum is up to 7 % too small'
grep -q "$says" out || { cat out; fail "not said of a ball that leaves"; }
! grep -q 'stage inside: [0-9]* particles have left' out || fail "said of a ball that is inside"
! grep -q 'warning: step' out || { cat out; fail "the watch warns of a ball that leaves"; }
echo ok

# what frana check warns of, the log of a run has in the same words: a block in a stream
cat >stream.yaml <<'YAML'
title: A block in a stream
domain: {size: [0.024, 0.012, 0.012], cells: [24, 12, 12]}
fluid:
  density: 1000
  viscosity: 1.0e-5
  sides:
    {x_low: {type: inflow, bulk_velocity: 0.05}, x_high: {type: outflow}, y_low: {type: wall}, y_high: {type: wall},
     z_low: {type: periodic}, z_high: {type: periodic}}
solid:
  materials: [{name: rubber, youngs_modulus: 1.0e5, density: 2000}]
  bodies: [{name: block, shape: box, low: [0.008, 0.004, 0.004], high: [0.012, 0.008, 0.008]}]
coupling: {}
stages: [{name: flow, steps: 1, solid: rigid}]
output: {series_every: 1, fields_every: 0, checkpoint_every: 0}
YAML
both() { # both TEXT|"" [--set KEY=VALUE]...: check and run say one warning with this text; "": they say none
  local text=$1; shift
  code 0 ranks 1 check stream.yaml "$@"
  sed -n 's/^ *warning: //p' out >want
  rm -rf stream
  code 0 ranks 1 run stream.yaml --out stream --quiet "$@"
  sed -n 's/^warning: //p' stream/run.log >got
  cmp -s want got || { cat want got; fail "check and the log differ: $*"; }
  [ "$(wc -l <want)" = "${text:+1}" ] || [ -z "$text$(cat want)" ] || { cat want; fail "other warnings: $*"; }
  grep -qF -- "$text" want || [ -z "$text" ] || { cat want; fail "not said: $text"; }
}
both "" # in the first step of a stream that starts at once a third of its power is lost by slip: no fault
both "body block ends on the outflow x_high" --set 'solid.bodies.0.low=[0.020, 0.004, 0.004]' \
  --set 'solid.bodies.0.high=[0.024, 0.008, 0.008]'
both "body block stands 0.001 m before the open side x_high" --set 'solid.bodies.0.low=[0.019, 0.004, 0.004]' \
  --set 'solid.bodies.0.high=[0.023, 0.008, 0.008]'
# a density in g/cm3
both "solid.materials.rubber.density = 2.65 kg/m3 is 0.00265 of the fluid's 1000 kg/m3" \
  --set solid.materials.0.density=2.65
both "" --set solid.materials.0.density=10
# a box beside the body has no permeability
box=(--set 'coupling.medium={low: [0.015, 0, 0], high: [0.02, 0.012, 0.012]}')
both "" "${box[@]}"
grep -q "^permeability is not measured: the medium's box holds no solid" stream/run.log ||
  fail "measured without a solid"
[ "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "permeability") k = i } END { print $k }' \
  stream/series.csv)" = nan ] || fail "an empty box has a permeability"
code 2 ranks 1 check stream.yaml "${box[@]}" --set coupling.medium.direction=x
grep -q "coupling.medium: the medium's box holds no solid" err || fail "asked for, and not refused: $(cat err)"

# a piston that is driven towards the closed end of a duct that it fills; the fluid cannot move
cat >piston.yaml <<'YAML'
title: A piston in a closed duct
domain: {size: [0.040, 0.008, 0.008], cells: [40, 8, 8]}
fluid:
  density: 1000
  viscosity: 1.0e-6
  sides:
    {x_low: {type: pressure}, x_high: {type: wall}, y_low: {type: slip}, y_high: {type: slip},
     z_low: {type: periodic}, z_high: {type: periodic}}
solid:
  materials: [{name: steel, youngs_modulus: 1.0e7, density: 2000}]
  bodies: [{shape: box, low: [0.010, -0.003, 0], high: [0.016, 0.011, 0.008]}]
  constraints: [{low: [0.010, -0.003, 0], high: [0.016, 0.011, 0.008], velocity: [0.02, 0, 0]}]
stages: [{name: push, steps: 20, time_step: 5.0e-4}]
output: {series_every: 10, fields_every: 0, checkpoint_every: 0}
YAML
code 0 ranks 1 run piston.yaml --out piston --quiet
says="warning: stage push: at its end 100 % of the power that the flow dissipates, .* is lost by slip"
grep -q "$says" piston/run.log ||
  { cat piston/run.log; fail "not said of a piston in a closed duct"; }
grep -q "$says.* walls: fluid is pressed through the solid" piston/run.log || fail "another reason for a piston"
code 0 ranks 1 run piston.yaml --out open --quiet --set fluid.sides.x_high.type=pressure
! grep "is lost by slip" open/run.log || fail "said of a piston in an open duct"
# a plug that the pressure moves with all of the fluid, as a body of their mass: 100 Pa over 34 kg/m2 and 12 kg/m2
code 0 ranks 1 run piston.yaml --out plug --quiet --set 'fluid.sides.x_low={type: pressure, pressure: 100}' \
  --set fluid.sides.x_high.type=pressure --set "solid.constraints=[]" --set 'solid.bodies.0.low=[0.010, 0, 0]' \
  --set 'solid.bodies.0.high=[0.016, 0.008, 0.008]' --set stages.push.time_step=1.0e-4
! grep "is lost by slip" plug/run.log || fail "said of a plug that floats along"
awk -F, '/^step/ { for (i = 1; i <= NF; i++) at[$i] = i } { t = $2; u = $at["u_bulk"] }
  END { exit !(u > 0.99 * 100 / 46 * t && u < 1.01 * 100 / 46 * t) }' plug/series.csv || fail "the plug's acceleration"
# a block on the floor of a tank has the load with fluid beneath it: check and the log say how much that is
cat >stands.yaml <<'YAML'
title: A block on the floor
domain: {size: [0.012, 0.012, 0.012], cells: [12, 12, 12]}
fluid:
  density: 1000
  viscosity: 1.0e-5
  body_force: [0, -9.81, 0]
  sides:
    {x_low: {type: wall}, x_high: {type: wall}, y_low: {type: wall}, y_high: {type: wall}, z_low: {type: wall},
     z_high: {type: wall}}
solid:
  materials: [{name: rubber, youngs_modulus: 1.0e4, density: 5000}]
  bodies: [{name: block, shape: box, low: [0.004, 0, 0.004], high: [0.008, 0.005, 0.008]}]
  body_force: [0, -9.81, 0]
stages: [{name: go, steps: 10, solid: rigid}]
output: {series_every: 10, fields_every: 0, checkpoint_every: 0}
YAML
says="body block stands on y_low with 1.6e-05 m2: the load on it is that with fluid beneath it, at rest 0.000785 N away"
says+=" from this side; sealed off there it would be 0.0011 N towards it, with pressures counted from the opposite side"
code 0 ranks "$(by_day 1 2)" check stands.yaml
grep -qF "$says" out || { cat out; fail "check does not say how a body stands"; }
code 0 ranks 1 run stands.yaml --out stands --quiet
[ "$(grep -cF "$says" stands/run.log)" = 1 ] || { cat stands/run.log; fail "the log does not say it once"; }
# the load is what was said, within 2 %: the flow is nearly at rest
awk -F, '/^step/ { for (i = 1; i <= NF; i++) at[$i] = i } { f = $at["load_y"] } END { exit !(f > 0.98 * 0.000785 &&
  f < 1.02 * 0.000785) }' stands/series.csv || fail "another load: $(cat stands/series.csv)"
# as much of a block that goes on below the floor
code 0 ranks 1 check stands.yaml --set 'solid.bodies.block.low=[0.004, -0.003, 0.004]'
grep -qF "$says" out || { cat out; fail "other numbers of a block that is held in the floor"; }
# and of one beside another that does not stand there
code 0 ranks 1 check stands.yaml --set 'solid.bodies=[
  {name: above, shape: box, low: [0.001, 0.002, 0.001], high: [0.003, 0.005, 0.003]},
  {name: block, shape: box, low: [0.004, 0, 0.004], high: [0.008, 0.005, 0.008]}]'
{ grep -qF "$says" out && [ "$(grep -c "stands on" out)" = 1 ]; } || { cat out; fail "other words of two bodies"; }
stands_not() {
  code 0 ranks 1 check stands.yaml "$@"
  ! grep -q "stands on" out || fail "said without reason: $*"
}
stands_not --set 'fluid.body_force=[0, 0, 0]'
stands_not --set 'fluid.body_force=[0, 9.81, 0]'
stands_not --set 'solid.bodies.block.low=[0.004, 0.001, 0.004]'
# one that comes down has it said at the stage's end
code 0 ranks 1 run stands.yaml --out lands --quiet --set 'solid.bodies.block.low=[0.004, 0.001, 0.004]' \
  --set 'solid.bodies.block.velocity=[0, -0.1, 0]' --set 'stages=[{name: go, steps: 12, time_step: 1.0e-3}]'
grep -q "^stage go: body block stands on y_low with" lands/run.log || fail "not said: $(cat lands/run.log)"
# bodies that fall freely with their fluid lose nothing to speak of, and that in the slip
cat >falls.yaml <<'YAML'
title: All falls
domain: {size: [0.024, 0.012, 0.012], cells: [24, 12, 12]}
fluid:
  density: 1000
  viscosity: 1.0e-6
  body_force: [1, -2, 0.5]
  sides:
    {x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: periodic}, y_high: {type: periodic},
     z_low: {type: periodic}, z_high: {type: periodic}}
solid:
  materials: [{name: light, youngs_modulus: 1.0e4, density: 100}, {name: heavy, youngs_modulus: 1.0e6, density: 1.0e5}]
  bodies:
    - {material: light, shape: sphere, centre: [0.006, 0.0061, 0.0057], radius: 0.0032}
    - {material: heavy, shape: sphere, centre: [0.0182, 0.0061, 0.0057], radius: 0.0032}
  body_force: [1, -2, 0.5]
stages: [{name: go, steps: 20, time_step: 2.0e-3}]
output: {series_every: 10, fields_every: 0, checkpoint_every: 0}
YAML
code 0 ranks 1 run falls.yaml --out falls --quiet
! grep "is lost by slip" falls/run.log || fail "said of what falls freely"
# nor does an oscillating flow where it turns, which is where the stage ends
cat >carried.yaml <<'YAML'
title: A ball as dense as the fluid is carried along
domain: {size: [1, 1, 1], cells: [12, 12, 12]}
fluid:
  density: 1
  viscosity: 0.01
  driving: {type: pressure_gradient, value: 1, frequency: 2}
  sides:
    {x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: periodic}, y_high: {type: periodic},
     z_low: {type: periodic}, z_high: {type: periodic}}
solid:
  materials: [{name: s, youngs_modulus: 1000, density: 1}]
  bodies: [{shape: sphere, centre: [0.51, 0.48, 0.5], radius: 0.3}]
stages: [{name: go, steps: 1000, duration: 1}]
output: {series_every: 10, fields_every: 0, checkpoint_every: 0}
YAML
code 0 ranks 1 run carried.yaml --out carried --quiet
! grep "is lost by slip" carried/run.log || fail "said of what an oscillating flow carries along"
# a box that is driven through wide water, 120 cells' width over nu a second: its layer is thinner than a cell
cat >swift.yaml <<'YAML'
title: A box that starts in wide water
domain: {size: [0.024, 0.016, 0.016], cells: [24, 16, 16]}
fluid:
  density: 1000
  viscosity: 1.0e-6
  sides:
    {x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: periodic}, y_high: {type: periodic},
     z_low: {type: periodic}, z_high: {type: periodic}}
solid:
  materials: [{name: rubber, youngs_modulus: 1.0e5, density: 2000}]
  bodies: [{shape: box, low: [0.006, 0.005, 0.005], high: [0.012, 0.011, 0.011]}]
  body_force: [4, 0, 0]
stages: [{name: go, steps: 60, time_step: 1.0e-3}]
output: {series_every: 10, fields_every: 0, checkpoint_every: 0}
YAML
code 0 ranks 1 run swift.yaml --out swift --quiet
grep -q "its speed times a cell over nu is [0-9.]*, so the layer at the walls is thinner than a cell" swift/run.log ||
  { cat swift/run.log; fail "nothing of a layer thinner than a cell"; }
