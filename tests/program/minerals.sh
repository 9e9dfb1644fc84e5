#!/usr/bin/env bash
# An image of three minerals is pulled apart: what check says of it; the same series on other ranks, and resumed in the
# middle on another number of ranks; the same rock at rest in a flow, and with fluid in a crack.
# usage: minerals.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# 24 x 10 x 9 voxels: blocks of 6 x 5 x 4 of the labels 1, 4 and 7, and every 31st voxel a pore
awk 'BEGIN {
  for (z = 0; z < 9; z++) for (y = 0; y < 10; y++) for (x = 0; x < 24; x++) {
    q = int(x / 6) * 5 + int(y / 5) * 7 + int(z / 4) * 4
    printf "\\%d", n++ % 31 == 30 ? 0 : 1 + 3 * (q % 3) } }' | xargs -0 printf '%b' >rock.raw
[ "$(wc -c <rock.raw)" = 2160 ] || fail "the sample has $(wc -c <rock.raw) bytes"
cat >scene.yaml <<'YAML'
title: An image of three minerals
domain: {size: [0.024, 0.010, 0.009]}
solid:
  spacing: 1.0e-3
  materials:
    - {name: quartz, youngs_modulus: 90.0e9, density: 2650, fracture_energy: 10}
    - {name: clay, youngs_modulus: 10.0e9, density: 1900, fracture_energy: 1}
    - {name: feldspar, youngs_modulus: 70.0e9, density: 2560, fracture_energy: 8}
  bodies:
    - name: rock
      shape: image
      file: rock.raw
      size: [24, 10, 9]
      type: uint8
      voxel: 1.0e-3
      solid: [1, 4, 7]
      materials: {1: quartz, 4: clay, 7: feldspar}
      low: [0, 0, 0]
  constraints:
    - {low: [0, 0, 0], high: [0.003, 0.01, 0.009], velocity: [-0.3, 0, 0]}
    - {low: [0.021, 0, 0], high: [0.024, 0.01, 0.009], velocity: [0.3, 0, 0]}
stages: [{name: pull, steps: 120, time_step: 2.0e-7, damping_relative: 1.0e15, breakage: true}]
output: {series_every: 10, fields_every: 60, checkpoint_every: 60, stress: true, events: true}
YAML
said() { # said TEXT: the output holds it
  grep -qF -- "$1" out || fail "not said: $1"
}
code 0 ranks 1 check scene.yaml
said '1      solid  668 voxels, 30.9259 %, quartz'
said 'materials  quartz: 668 voxels, 31.9464 % of the solid'
said '             clay: 755 voxels, 36.1071 % of the solid'
said 'borders    905 faces between voxels of two materials: 0.000905 m2, '
said 'pores white, quartz grey, clay blue, feldspar sky blue'

code 0 ranks 2 run scene.yaml --out two
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 && $1 == 60 { half = $at["crack_area"] }
  END { exit !(half > 0 && $at["crack_area"] > half) }' two/series.csv || fail "nothing breaks in one of the halves"
# what the events have released is the series' e_fracture, with the limits and stiffnesses of each pair
released=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR > 2 { sum += $at["energy"] }
  END { printf "%.17g", sum }' two/events.csv)
awk -F, -v sum="$released" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } { last = $at["e_fracture"] }
  END { d = sum - last; exit !(last > 0 && d * d < 1e-20 * last * last) }' two/series.csv ||
  fail "the events' energies are $released J in all"
grep -aq material two/fields/solid_00000060.hdf || fail "no materials in the fields"
for n in 1 $(by_day "" 4); do
  code 0 ranks $n run scene.yaml --out ranks$n
  same two/series.csv ranks$n/series.csv
done
code 0 ranks "$(by_day 1 3)" run scene.yaml --out again --resume=two/checkpoint/step_00000060.h5
sed -n '1,2p' two/series.csv >tail.csv && awk -F, 'NR > 2 && $1 > 60' two/series.csv >>tail.csv
same tail.csv again/series.csv
# labels of one material are one label: every bit
one='solid.bodies[0].materials={1: clay, 4: clay, 7: clay}'
code 0 ranks 1 run scene.yaml --out one --set "$one"
sed '/materials: {1/s/.*/      material: clay/' scene.yaml >plain.yaml
code 0 ranks 1 run plain.yaml --out plain
cmp one/series.csv plain/series.csv || fail "labels of one material differ from one label"
# a rock at rest in a flow: its materials change no bit, and the fields name them
driving='driving: {type: pressure_gradient, direction: x, value: 1.0e-3}'
sides=$(for at in x_low x_high y_low y_high z_low z_high; do printf '%s: {type: periodic}, ' $at; done)
sed -e '/constraints:/,/0.021/d' -e 's/^output.*/output: {series_every: 1, fields_every: 5}/' \
  -e 's/^domain.*/domain: {size: [0.024, 0.010, 0.018], cells: [24, 10, 18]}/' \
  -e "s/^solid:/fluid:\n  density: 1000\n  viscosity: 1.0e-3\n  $driving\n  sides: {${sides%, }}\n&/" \
  -e 's/^stages.*/coupling: {}\nstages: [{name: flow, steps: 5, time_step: 1.0e-3, solid: rigid}]/' \
  scene.yaml >flow.yaml
sed '/materials: {1/s/.*/      material: clay/' flow.yaml >flow_plain.yaml
code 0 ranks 1 run flow.yaml --out flow
code 0 ranks 1 run flow_plain.yaml --out flow_plain
cmp flow/series.csv flow_plain/series.csv || fail "the materials of a solid at rest change the flow"
grep -aq material flow/fields/solid_00000005.hdf || fail "no materials in the fields of a solid at rest"
# fluid in a crack across the minerals
crack='[[0.006, 0.003, 0.0045], [0.018, 0.003, 0.0045], [0.018, 0.007, 0.0045], [0.006, 0.007, 0.0045]]'
pump='stages: [{name: pump, steps: 20, integrator: verlet, crack_fluid: true, breakage: true}]'
given='{low: [0.009, 0.003, 0.002], high: [0.015, 0.007, 0.007], pressure: 3.0e7, time: [[0, 0], [1.0e-5, 1]]}'
sed -e '/constraints:/,/0.021/d' -e 's/^output.*/output: {series_every: 10}/' \
  -e "s/^stages.*/  cracks: [{points: $crack}]\ncrack_fluid:\n  viscosity: 1.0e-3\n  injections: [$given]\n$pump/" \
  scene.yaml >wet.yaml
code 0 ranks 1 run wet.yaml --out wet
if thorough; then # by day crack_fluid.sh has fluid in a crack on more ranks
  code 0 ranks 3 run wet.yaml --out wet_3
  same wet/series.csv wet_3/series.csv
fi
echo ok
