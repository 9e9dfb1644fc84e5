#!/usr/bin/env bash
# A fluid alone on very small grids, and with very large and very small numbers.
# shellcheck source=tests/program/extreme/extreme.sh
. "$(dirname "$0")/extreme.sh" "$@"
walls=() across=()
for side in x_low x_high y_low y_high z_low z_high; do walls+=(--set "fluid.sides.$side.type=wall"); done
for side in y_low y_high; do across+=(--set "fluid.sides.$side.type=wall"); done
vortices=(--set 'fluid.initial={taylor_green: {velocity: 1}}')
levels='output.fluid_probes={every: 50, at: [[0.5, 0.25, 0.5], [0.5, 0.75, 0.5]]}'

for cells in 1 2; do
  go 1 0 "$fluid" --set "domain.cells=[$cells, $cells, $cells]" --set 'fluid.body_force=[1, 0, 0]'
  near "u" "$(last t)" 1e-12 "$(last u_bulk)"
done
row "1 × 1 × 1 and 2 × 2 × 2 periodic cells under a body force" "u = g t"
go 4 0 "$fluid" --set 'domain.cells=[2, 2, 2]' --set 'fluid.body_force=[0, -10, 0]' "${walls[@]}" --set "$levels"
near "pressure" 2500 1e-9 "$(fluid_probe 0 p)"
less "kinetic energy" "$(last e_kinetic_fluid)" 1e-25
row "2 × 2 × 2 cells in a closed box, on four ranks" "hydrostatic to 1e-12"
go 8 2 "$fluid" --set 'domain.cells=[2, 2, 2]' "${walls[@]}"
row "the same on eight ranks" "is refused"
go "$few" 0 "$fluid" --set 'fluid.body_force=[3, -10, 2]' "${walls[@]}" --set "$levels"
near "pressure below" 2500 1e-9 "$(fluid_probe 0 p)"
near "pressure above" -2500 1e-9 "$(fluid_probe 1 p)"
less "kinetic energy" "$(last e_kinetic_fluid)" 1e-25
row "a closed box under a slanted body force" "hydrostatic to 1e-12, no flow"
go "$few" 0 "$fluid" --set 'domain.cells=[4, 512, 4]' --set 'domain.size=[0.0078125, 1, 0.0078125]' "${across[@]}" \
  --set 'fluid.initial={velocity: [1, 0, 0], poiseuille: true}' \
  --set 'fluid.driving={type: pressure_gradient, value: 12}' --set output.series_every=10
near "mean velocity" 1 1e-7 "$(last u_bulk)"
row "4 × 512 × 4 cells: Poiseuille's flow" "stands"
go 2 0 "$fluid" --set 'domain.size=[1000, 1, 1000]' "${vortices[@]}"
less "kinetic energy" "$(last e_kinetic_fluid)" "$(of 1 e_kinetic_fluid)"
row "a domain of 1000 : 1 : 1000" "vortices decay"

# the decay of the differences is exp(-2 lambda t), lambda = nu 2 (2/d sin(k d/2))^2; RK3 at 0.9 of its limit is
# accurate to a few per cent
go 1 0 "$fluid" --set fluid.viscosity=1e-12 "${vortices[@]}"
near "kinetic energy" 250 1e-4 "$(last e_kinetic_fluid)"
row "viscosity 1e-12 m²/s" "Taylor and Green's vortices keep their energy"
go 1 0 "$fluid" --set fluid.viscosity=1e6 "${vortices[@]}"
near "logarithm of the decay over t" "$(calc '-4e6 * (16 * sin(atan2(0, -1) / 8)) ^ 2')" 1e6 \
  "$(calc "log($(last e_kinetic_fluid) / $(of 1 e_kinetic_fluid)) / ($(last t) - $(of 1 t))")"
row "viscosity 1e6 m²/s" "they decay as they should, in steps of 2 ns"
for density in 1e-300 1e300; do
  go 1 0 "$fluid" --set "fluid.density=$density" "${vortices[@]}"
  less "kinetic energy over density" "$(calc "$(last e_kinetic_fluid) / $density")" 0.25
done
row "density 1e-300 and 1e300 kg/m³" "runs"
go 1 3 "$fluid" --set stages.run.time_step=1e300 "${vortices[@]}"
[ -f run/checkpoint/latest ] || fail "no checkpoint"
row "a fluid's step of 1e300 s" "the state before it is kept"
go 1 2 "$fluid" --set stages.run.time_step=1e-300 "${vortices[@]}"
row "a fluid's step of 1e-300 s" "is refused"
echo ok
