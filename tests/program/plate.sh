#!/usr/bin/env bash
# A plate that cracks: the same series on any number of ranks, stopped and resumed on another number; its output files;
# refused inputs.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
plate() {
  cat <<YAML
title: A plate torn
domain: {size: [0.02, 0.01]}
solid:
  model: plane_stress
  thickness: 0.002
  spacing: 0.0005
  materials:
    - {name: glass, youngs_modulus: 72e9, density: 2440, fracture_energy: 135}
  bodies:
    - {name: plate, material: glass, shape: rectangle, low: [0, 0], high: [0.02, 0.01]}
  cracks:
    - {points: [[$1, 0.005], [$2, 0.005]]}
  constraints:
    - {low: [0.018, 0], high: [0.02, 0.01], directions: x, displacement: [1.0e-6, 0], time: [[0, 0], [3.0e-6, 1]]}
  loads:
    - {edge: {from: [0, 0], to: [0.018, 0]}, traction: [0, -3.0e7], time: [[0, 0], [1.0e-6, 1]]}
    - {edge: {from: [0, 0.01], to: [0.018, 0.01]}, traction: [0, 3.0e7], depth: horizon, time: [[0, 0], [1.0e-6, 1]]}
  initial:
    - {shape: gaussian, along: y, centre: 0.005, width: 0.001, displacement: [1.0e-8, 0]}
stages:
  - {name: tear, steps: 160, time_step: 5.0e-8, integrator: $3}
output: {series_every: 10, fields_every: 80, checkpoint_every: 90}
YAML
}
value() { awk -F, -v c="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i } END { print $k }' "$1"; }

for integrator in verlet rk3; do
  plate 0 0.008 $integrator >scene.yaml
  code 0 ranks 1 run scene.yaml --out one_$integrator
  code 0 ranks 3 run scene.yaml --out three_$integrator
  same one_$integrator/series.csv three_$integrator/series.csv
  code 0 ranks 2 run scene.yaml --out two_$integrator --resume=three_$integrator/checkpoint/step_00000090.h5
  awk -F, 'NR <= 2 || $1 > 90' one_$integrator/series.csv >tail.csv
  same tail.csv two_$integrator/series.csv
  awk "BEGIN { exit !($(value one_$integrator/series.csv bonds_broken) > 500) }" || fail "the crack has not grown"
done
[ -f one_rk3/fields/solid_00000160.hdf ] || fail "no field"
for field in damage displacement velocity stretch_max energy_density volume; do
  h5dump -n one_rk3/fields/solid_00000160.hdf 2>/dev/null | grep -q "/PointData/$field" ||
    ! command -v h5dump >/dev/null || fail "no field $field"
done

# energy balance to the integrator's own order, with the energy of broken bonds
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i } NR > 2 {
  left = $k["e_kinetic_solid"] + $k["e_strain"] + $k["e_damped"] + $k["e_fracture"] \
    - $k["work_load"] - $k["e_constraint"]
  if (NR == 3) start = left
  left -= start; if (left < 0) left = -left
  if (left > worst) worst = left; if ($k["e_kinetic_solid"] > most) most = $k["e_kinetic_solid"] }
  END { print "unbalanced", worst / most; exit !(worst < 1e-2 * most) }' one_rk3/series.csv || fail "energy is lost"

code 0 ranks 1 check scene.yaml
for line in "plane stress, 0.002 m thick" "Rayleigh's 3058" "solid, bonds, velocity Verlet"; do
  grep -q "$line" out || fail "frana check does not say: $line"
done
plate 0.03 0.04 rk3 >outside.yaml
code 2 ranks 1 run outside.yaml --out outside
grep -q "crack" err || fail "a crack outside the body: $(cat err)"
echo ok
