#!/usr/bin/env bash
# Large strain and large contrasts: a cube pressed to half, dry and in a fluid; stiffness and density that differ by 1e6
# and 1e3 within a horizon; a sheet of one particle in a fluid. The solid's energy balance must close.
# shellcheck source=tests/program/extreme/extreme.sh
. "$(dirname "$0")/extreme.sh" "$@"
# closed MOST: the log says that the balance of the stage has closed to less than this
closed() { less "balance" "$(sed -n 's/.*energy balance has closed to \([^ ]*\) of.*/\1/p' run/run.log)" "$1"; }

cube='solid.bodies=[{shape: box, low: [0.03, 0.03, 0.03], high: [0.13, 0.08, 0.08]}]'
still='{low: [0.11, 0, 0], high: [0.13, 0.1, 0.1]}'
plates="solid.constraints=[{low: [0.03, 0, 0], high: [0.05, 0.1, 0.1], velocity: [2.0, 0, 0]}, $still]"
go 1 0 "$solid" --set "$cube" --set "$plates" \
  --set 'stages=[{name: run, steps: 500, time_step: 5.0e-5, integrator: verlet}]'
near "way of the plate" 0.05 1e-9 "$(calc "2 * $(last t)")"
closed 0.01
row "a bar of ten spacings whose ends come nearer by half of its length, dry" "the energy balance closes to 1 %"

cube='solid.bodies=[{name: body, shape: box, low: [0.004, 0.005, 0.005], high: [0.012, 0.011, 0.011]}]'
still='{low: [0.010, 0, 0], high: [0.016, 0.016, 0.016]}'
plates="solid.constraints=[{low: [0, 0, 0], high: [0.006, 0.016, 0.016], velocity: [0.5, 0, 0]}, $still]"
go 2 0 "$immersed" --set "$cube" --set "$plates" \
  --set 'stages=[{name: run, steps: 80, time_step: 5.0e-5, integrator: verlet}]'
closed 0.01
less "momentum residual" "$(last momentum_residual)" 1e-8
row "a block whose middle is pressed to half in a closed box of fluid" \
  "the solid's energy balance closes to 1 %, momentum to 1e-8"

one='{name: one, material: stuff, shape: box, low: [0.03, 0.03, 0.03], high: [0.08, 0.08, 0.08]}'
two='{name: two, material: other, shape: box, low: [0.08, 0.03, 0.03], high: [0.13, 0.08, 0.08]}'
halves="solid.bodies=[$one, $two]"
bonded='solid.interfaces=[{between: [one, two], fracture_energy: .inf}]'
pulled='solid.loads=[{low: [0.11, 0, 0], high: [0.13, 0.1, 0.1], force: [1.0e4, 0, 0]}]'
for of in 'stiffness 1.0e12 1000 1e6' 'density 1.0e6 1.0e6 1e3'; do
  read -r what e rho contrast <<<"$of"
  stuff="{name: stuff, youngs_modulus: 1.0e6, density: 1000, fracture_energy: .inf}"
  other="{name: other, youngs_modulus: $e, density: $rho, fracture_energy: .inf}"
  go 1 0 "$solid" --set "solid.materials=[$stuff, $other]" \
    --set "$halves" --set "$bonded" --set "$pulled" --set stages.run.steps=2000 --set output.series_every=100
  closed 0.001
  near "momentum over the load's" 1 1e-6 "$(calc "$(last momentum_x) / (1e4 * 50e-6 * $(last t))")"
  row "$what that differs by $contrast within a horizon" "energy closes to 0.1 %, momentum is the load's to 1e-6"
done

sheet='solid.bodies=[{name: body, shape: box, low: [0.007, 0.003, 0.004], high: [0.008, 0.012, 0.012]}]'
swung='solid.constraints=[{low: [0, 0, 0], high: [0.016, 0.006, 0.016], velocity: [0.05, 0, 0]}]'
go "$few" 0 "$immersed" --set "$sheet" --set "$swung" \
  --set 'stages=[{name: run, steps: 200, time_step: 2.0e-4, integrator: verlet}]'
closed 0.01
less "momentum residual" "$(last momentum_residual)" 1e-8
row "a sheet of one particle's thickness that is moved by its edge through a fluid" \
  "the solid's energy balance closes to 1 %, momentum to 1e-8"
echo ok
