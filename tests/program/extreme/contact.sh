#!/usr/bin/env bash
# Bodies that meet: at speed, across a periodic side, from the start, and under pressure. The energy of contact is not
# in the balance; momentum is conserved.
# shellcheck source=tests/program/extreme/extreme.sh
. "$(dirname "$0")/extreme.sh" "$@"
# cubes of 27 particles 3 cm apart; the first is given 10 m/s within 0.1 ms
cubes='{name: first, shape: box, low: [0.02, 0.03, 0.03], high: [0.05, 0.06, 0.06]}'
cubes="solid.bodies=[$cubes, {name: second, shape: box, low: [0.08, 0.03, 0.03], high: [0.11, 0.06, 0.06]}]"
box() { echo "{shape: box, low: [$1], high: [$2]}"; }
impulse='time: [[0, 1], [1.0e-4, 1], [1.00000001e-4, 0]]'
places() { # X...: positions of the particles of cubes
  local x y z list=
  for x in "$@"; do
    for y in 0.035 0.045 0.055; do for z in 0.035 0.045 0.055; do list="$list, [$x, $y, $z]"; done; done
  done
  echo "output.probes={every: 3000, at: [${list#, }]}"
}
collide=(--set "$cubes" --set "solid.loads=[{low: [0, 0, 0], high: [0.06, 0.1, 0.1], force: [1.0e8, 0, 0], $impulse}]"
  --set solid.materials.stuff.youngs_modulus=1.0e9
  --set 'stages=[{name: run, steps: 3000, time_step: 2.0e-6, integrator: verlet}]' --set output.series_every=10)
go 2 0 "$solid" "${collide[@]}" --set "$(places 0.025 0.035 0.045)"
first=$(calc "$(of 3000 velocity_x run/probes.csv) / 27")
near "momentum across" 0 1e-12 "$(of 3000 velocity_y run/probes.csv)"
went=$(of 100 work_load) now=$(calc "$(last e_kinetic_solid) + $(last e_strain)")
go 2 0 "$solid" "${collide[@]}" --set "$(places 0.085 0.095 0.105)"
second=$(calc "$(of 3000 velocity_x run/probes.csv) / 27")
near "momentum over a body's mass" 10.00000005 1e-12 "$(calc "$first + $second")"
less "speed of the first" "$(calc "$first < 0 ? -$first : $first")" 1
near "energy, of which contact books none while it lasts" "$went" "$(calc "0.02 * $went")" "$now"
row "two bodies collide at 10 m/s, no fluid" \
  "momentum kept to 1e-12, energy to 2 %; the second goes on, the first stays"

# the same cubes at 0.2 of the speed of sound each, with a step of two stable ones: more substeps, only while they meet
fast='{name: first, shape: box, low: [0.02, 0.03, 0.03], high: [0.05, 0.06, 0.06], velocity: [200, 0, 0]}'
back='{name: second, shape: box, low: [0.08, 0.03, 0.03], high: [0.11, 0.06, 0.06], velocity: [-200, 0, 0]}'
go 2 0 "$solid" --set "solid.bodies=[$fast, $back]" --set solid.materials.stuff.youngs_modulus=1.0e9 \
  --set output.series_every=10 \
  --set 'stages=[{name: run, steps: 100, time_step: 2.0e-5, integrator: verlet, breakage: false}]'
went=$(of 0 e_kinetic_solid) now=$(calc "$(last e_kinetic_solid) + $(last e_strain)")
near "energy after the impact" "$went" "$(calc "0.03 * $went")" "$now"
near "momentum along" 0 1e-9 "$(last momentum_x)"
row "two bodies collide at 0.2 of the speed of sound each" "energy kept to 3 %, by more substeps while they meet"

for n in 1 2; do
  go $n 0 "$solid" --set 'domain.periodic=[true, false, false]' \
    --set "solid.bodies=[$(box '0.17, 0.05, 0.05' '0.18, 0.06, 0.06'), $(box '0.01, 0.05, 0.05' '0.02, 0.06, 0.06')]" \
    --set "solid.loads=[{low: [0.1, 0, 0], high: [0.2, 0.1, 0.1], force: [1.0e8, 0, 0], $impulse}]" \
    --set 'stages=[{name: run, steps: 1000, time_step: 1.0e-5, integrator: verlet}]' \
    --set 'output.probes={every: 1000, at: [[0.175, 0.055, 0.055], [0.015, 0.055, 0.055]]}'
  cp run/probes.csv probes$n.csv
done
cmp probes1.csv probes2.csv || fail "one and two ranks differ"
near "velocity of the one that hits" 0 0.01 "$(probe 0 1000 velocity_x)"
near "velocity of the one that is hit" 10 0.01 "$(probe 1 1000 velocity_x)"
near "momentum" 10.00000005 1e-12 "$(of 1000 velocity_x run/probes.csv)"
row "a fragment crosses a periodic side and hits one behind it" "they swap velocities, the same to the bit on two ranks"

left=$(box '0.02, 0.03, 0.03' '0.05, 0.06, 0.06')
go 2 0 "$solid" --set "solid.bodies=[$left, $(box '0.05, 0.03, 0.03' '0.08, 0.06, 0.06')]"
near "kinetic energy" 0 0 "$(last e_kinetic_solid)"
row "two bodies touch, a spacing apart" "they rest, without a force between them"
go 2 2 "$solid" --set "solid.bodies=[$left, $(box '0.04, 0.03, 0.03' '0.08, 0.06, 0.06')]"
row "two bodies overlap" "is refused"
printf '0.05 0.05 0.05 1.0e-6\n0.05 0.05 0.05 1.0e-6\n' >twice.txt
go 1 2 "$solid" --set "solid.bodies=[{shape: points, file: $PWD/twice.txt}]" --set stages.run.time_step=1e-5
row "two points in one place" "is refused"
printf '0.045 0.045 0.045 1.0e-6\n' >once.txt
block='{name: block, shape: box, low: [0.04, 0.04, 0.04], high: [0.06, 0.05, 0.05]}'
go 2 2 "$solid" --set "solid.bodies=[{name: grain, shape: points, file: $PWD/once.txt}, $block]" \
  --set stages.run.time_step=1e-5
row "a point in the place of another body's particle" "is refused"
go 1 0 "$solid" --set 'domain.periodic=[true, false, false]' \
  --set 'solid.bodies=[{shape: box, low: [-0.1, 0.05, 0.05], high: [0.3, 0.06, 0.06]}]'
near "bonds, three to each side of 20 particles" 60 0 "$(last bonds_intact)"
row "a body wider than the domain across a periodic side" "fills the period once"
go 1 0 "$solid" --set 'domain.periodic=[true, false, false]' \
  --set 'solid.bodies=[{shape: box, low: [0, 0.05, 0.05], high: [0.2, 0.06, 0.06]}]'
near "bonds, three to each side of 20 particles" 60 0 "$(last bonds_intact)"
row "a body as wide as the domain across a periodic side" "is bonded to itself"

# a plunger pushes a column against a held one
plunger='{low: [0, 0, 0], high: [0.03, 0.1, 0.1], velocity: [1, 0, 0]}'
go 2 0 "$solid" \
  --set "solid.bodies=[$(box '0.02, 0.03, 0.03' '0.06, 0.06, 0.06'), $(box '0.065, 0.03, 0.03' '0.11, 0.06, 0.06')]" \
  --set "solid.constraints=[$plunger, {low: [0.10, 0, 0], high: [0.12, 0.1, 0.1]}]" \
  --set solid.materials.stuff.youngs_modulus=1.0e7 \
  --set 'stages=[{name: run, steps: 1000, time_step: 1.0e-5, integrator: verlet}]'
put=$(last e_constraint) has=$(calc "$(last e_kinetic_solid) + $(last e_strain)")
less "energy of both columns" "$has" "$put"
less "half the plunger's work" "$(calc "0.5 * $put")" "$has"
near "bodies" 2 0 "$(last fragments)"
row "a plunger drives one body into another" "its work is in both; the rest is held by contact"
echo ok
