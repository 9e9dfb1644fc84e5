#!/usr/bin/env bash
# Bodies in a fluid that touch all sides, block the channel, or are very small.
# shellcheck disable=SC2046 # body prints several words
# shellcheck source=tests/program/extreme/extreme.sh
. "$(dirname "$0")/extreme.sh" "$@"
body() { echo --set "solid.bodies.body.low=[$1]" --set "solid.bodies.body.high=[$2]"; }
through=(--set fluid.sides.x_low.type=inflow --set fluid.sides.x_low.bulk_velocity=0.01
  --set fluid.sides.x_high.type=outflow --set 'fluid.initial.velocity=[0.01, 0, 0]')
slip=()
for side in y_low y_high z_low z_high; do slip+=(--set "fluid.sides.$side.type=slip"); done
rigid=(--set stages.run.solid=rigid)
grain() { echo "solid.bodies=[{name: grain, shape: sphere, centre: [$1], radius: 0.0006}]"; }

go 2 0 "$immersed" --set "$(grain '0.0085, 0.0125, 0.0085')" --set 'solid.body_force=[0, -0.1, 0]' \
  --set 'output.probes={every: 100, at: [[0.0085, 0.0125, 0.0085]]}'
weight=2e-7 # N: 2000 kg/m3, 1 mm3, 0.1 m/s2
near "what the fluid gets" "$(calc "-($(last load_y))")" 1e-20 "$(last forcing_y)"
less "drag before it balances the weight" "$(last load_y)" $weight
less "nine tenths of the weight" "$(calc "0.9 * $weight")" "$(last load_y)"
# Stokes: 3 pi mu d U, with d of a sphere of equal volume; U includes the grain's own wake
near "drag over Stokes'" 0.8 0.2 \
  "$(calc "$(last load_y) / (3 * 3.14159265 * 0.01 * 1.2407e-3 * -($(probe 0 100 velocity_y)))")"
grep -q 'slip at the solid.s walls: particles without a bond take their drag by slip' run/run.log ||
  fail "a single particle's drag is said to be flow through a wall"
row "one particle in a fluid at rest" "falls under 0.6 to 1 of Stokes' drag; momentum kept to round-off"

go 1 0 "$immersed" "${through[@]}" $(body '0,0,0' '0.016,0.008,0.016') "${rigid[@]}"
near "mean velocity" 0.01 1e-15 "$(last u_bulk)"
less "divergence" "$(last div_max)" 1e-12
less "momentum residual" "$(last momentum_residual)" 1e-10
near "effective porosity" 0 1e-12 "$(last porosity_effective)"
grep -q 'warning: 50 % of x_low have no way out' run/run.log || fail "the log does not warn"
row "a body touches inlet, wall and outlet" \
  "the prescribed inflow is pressed through it where it touches the inlet; a warning says so"
# a post between given pressures, which drive about sqrt(2 dp/density) = 1.4 m/s: the number of a cell is velocity over
# viscosity times 1e-3 m
cat >post.yaml <<'EOS'
domain: {size: [0.032, 0.016, 0.016], cells: [32, 16, 16]}
fluid:
  density: 1000
  viscosity: 1.0e-5
  sides: {x_low: {type: pressure, pressure: 1000}, x_high: {type: pressure}, y_low: {type: wall}, y_high: {type: wall},
    z_low: {type: wall}, z_high: {type: wall}}
solid:
  materials: [{name: m, youngs_modulus: 1.0e9, density: 2000}]
  bodies: [{shape: box, low: [0.012, -0.003, 0.006], high: [0.016, 0.010, 0.010]}]
stages: [{name: run, steps: 1200, solid: rigid}]
output: {fields_every: 0, checkpoint_every: 0}
EOS
go 1 0 post.yaml
less "velocity" "$(last u_bulk)" 6
less "pressure drop" "$(last dp)" 5000
less "load" "$(last load_x)" 1
less "momentum residual" "$(last momentum_residual)" 1e-10
row "a post between given pressures, with a cell Reynolds number of 370" "velocity, Δp and load are bounded"
go 1 0 post.yaml --set fluid.viscosity=1e-7 --set stages.run.steps=100
grep -q 'warning: step [0-9]*: the Reynolds number of a cell, U d/nu, is .*e+04: the run is hopeless' run/run.log ||
  fail "the log does not warn"
row "the same with a cell Reynolds number above 1e4" "the log says that the run is hopeless"
go 2 0 "$immersed" "${through[@]}" $(body '0.004,-0.003,-0.003' '0.008,0.019,0.019') "${rigid[@]}"
near "mean velocity" 0.01 1e-15 "$(last u_bulk)"
less "momentum residual" "$(last momentum_residual)" 1e-10
near "porosity" 0 1e-12 "$(last porosity_effective)"
less "10 Pa, a hundred thousand times the flow's own" 10 "$(last dp)"
grep -q 'warning: 100 % of x_low have no way out' run/run.log || fail "the log does not warn"
row "a block fills the channel" "the prescribed inflow is pressed through it; a warning says so"

# closed pore: a hollow cube
hollow='{name: body, shape: box, low: [0.003, 0.003, 0.003], high: [0.013, 0.013, 0.013], '
hollow="solid.bodies=[${hollow}cavities: {period: 0.1, radius: 0.0035, centre: [0.008, 0.008, 0.008]}}]"
inside='output.fluid_probes={every: 100, at: [[0.008, 0.007, 0.008], [0.008, 0.009, 0.008], [0.008, 0.001, 0.008]]}'
go 1 0 "$immersed" --set "$hollow" "${rigid[@]}" --set "$inside" --set 'fluid.body_force=[0, -10, 0]'
for p in 0 1 2; do near "pressure at $p" "$(calc "$p == 0 ? 10 : $p == 1 ? -10 : 70")" 1e-4 "$(fluid_probe $p p)"; done
less "kinetic energy" "$(last e_kinetic_fluid)" 1e-14
row "a pore closed on all sides, under gravity" "its pressure is hydrostatic to 1e-6"
go 1 0 "$immersed" --set "$hollow" "${rigid[@]}" --set "$inside" "${through[@]}" "${slip[@]}"
less "flow in the pore over that outside" "$(calc "-($(fluid_probe 0 u)) / 0.01")" 0.01
near "pressure's difference in the pore" 0 1e-12 "$(calc "$(fluid_probe 0 p) - $(fluid_probe 1 p)")"
row "the same in a stream" "at rest to 1 %"

# Archimedes: a block of 216 mm3 hangs in a closed box; nothing drives the fluid, and all comes to rest
held='solid.constraints=[{low: [0, 0.0099, 0], high: [0.016, 0.016, 0.016]}]'
go 1 0 "$immersed" $(body '0.005,0.005,0.005' '0.011,0.011,0.011') --set "$held" \
  --set 'solid.body_force=[0, -9.81, 0]' --set 'fluid.body_force=[0, -9.81, 0]' \
  --set 'stages=[{name: run, steps: 600, until: {quantity: rest}}]' \
  --set output.series_every=20 --set solid.materials.stuff.fracture_energy=1
grep -q 'stage run: at rest after' run/run.log || fail "does not come to rest"
near "buoyancy" 2.11896e-3 2e-7 "$(last load_y)"
near "what holds it" 2.11896e-3 2e-7 "$(of last force_y run/reactions.csv)"
row "a block held in a closed box, twice as dense as the fluid, until all is at rest" \
  "its load is the weight of the fluid that it displaces, to 1e-4, and so is its support's"
go 1 0 "$immersed" --set solid.spacing=0.25e-3 $(body '0.008,0.008,0.008' '0.009,0.009,0.009') \
  --set 'solid.body_force=[0, -0.1, 0]'
less "momentum residual" "$(last momentum_residual)" 1e-10
less "kinetic energy of the body" "$(last e_kinetic_solid)" 1e-10 # slower than 1 cm/s
row "a body of 64 particles wholly in one cell" "sinks, bounded; the forces on it are not resolved"
go 1 0 "$immersed" "${through[@]}" "${slip[@]}" $(body '0.008,0.004,0.004' '0.009,0.012,0.012') \
  --set 'solid.constraints=[{low: [0, 0, 0], high: [0.016, 0.016, 0.016]}]'
less "drag on a plate held across the stream" 0 "$(calc "-($(last forcing_x))")"
near "particles wetted on both sides" 64 0 "$(last interface_particles)"
row "a plate one particle thick across the stream" "is wetted on both sides"

go 2 0 "$immersed" --set solid.materials.stuff.density=1 --set 'solid.body_force=[0, 1, 0]' --set stages.run.steps=400
near "load over the push" -6.4e-8 1e-10 "$(last load_y)"
less "momentum residual" "$(last momentum_residual)" 1e-10
row "an elastic body of a thousandth of the fluid's density" "rises; the load balances the push"
go 1 0 "$immersed" --set solid.materials.stuff.density=300 --set 'solid.body_force=[0, 1, 0]'
less "momentum residual" "$(last momentum_residual)" 1e-10
less "kinetic energy of the body" "$(last e_kinetic_solid)" 1e-7
row "an elastic body of 0.3 of the fluid's density" "rises, bounded over 100 steps"
go 1 0 "$immersed" --set solid.materials.stuff.density=1e7 --set 'solid.body_force=[0, 1, 0]'
near "kinetic energy" 3.2e-3 "$(calc '0.01 * 3.2e-3')" "$(last e_kinetic_solid)"
row "a body of 10,000 times the fluid's density" "falls freely to 1 %"
go 1 0 "$immersed" --set fluid.viscosity=1e-12 --set 'solid.body_force=[0, -0.1, 0]'
less "momentum residual" "$(last momentum_residual)" 1e-10
row "a body sinks in a fluid of viscosity 1e-12 m²/s" "sinks on: a body that moves in a fluid at rest ends no run"
go 1 0 "$immersed" --set fluid.viscosity=1e6 --set 'solid.body_force=[0, -0.1, 0]' --set stages.run.time_step=auto
less "momentum residual" "$(last momentum_residual)" 1e-10
row "a body sinks in a fluid of viscosity 1e6 m²/s" "runs, in steps of 0.1 ps"
go 1 0 "$immersed" --set solid.materials.stuff.youngs_modulus=1e12 --set 'solid.body_force=[0, -0.1, 0]' \
  --set stages.run.steps=3
less "strain energy over kinetic" "$(calc "$(last e_strain) / $(last e_kinetic_solid)")" 1e-6
row "a body of E = 1e12 Pa in a fluid" "6,000 substeps a step"
if thorough; then
  go 4 0 "$immersed" --set "$(grain '0.0085, 0.0125, 0.0085')" --set 'solid.body_force=[0, -0.1, 0]' \
    --set output.series_every=50 && mv run four
  go 1 0 "$immersed" --set "$(grain '0.0085, 0.0125, 0.0085')" --set 'solid.body_force=[0, -0.1, 0]' \
    --set output.series_every=50
  near "load on four ranks" "$(last load_y)" 1e-18 "$(last load_y four/series.csv)"
  row "one particle in a fluid on four ranks" "as on one"
fi
round=(--set fluid.sides.x_low.type=periodic --set fluid.sides.x_high.type=periodic --set stages.run.steps=3)
go 1 0 "$immersed" "${round[@]}" $(body '0,0.006,0.006' '0.016,0.01,0.01') && mv run as_wide
go 1 0 "$immersed" "${round[@]}" $(body '-0.004,0.006,0.006' '0.020,0.01,0.01')
same as_wide/series.csv run/series.csv
row "a body wider than the domain across the fluid's periodic sides" "as one that is as wide"
echo ok
