#!/usr/bin/env bash
# A plate that cracks: the same series on any number of ranks, stopped and resumed on another number; its output files;
# refused inputs.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# shellcheck source=tests/program/scenes.sh
. "$source/tests/program/scenes.sh"
value() { awk -F, -v c="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i } END { print $k }' "$1"; }

for integrator in verlet rk3; do
  torn_plate 0 0.008 "integrator: $integrator" >scene.yaml
  code 0 ranks 1 run scene.yaml --out one_$integrator
  code 0 ranks "$(by_day 2 3)" run scene.yaml --out three_$integrator
  same one_$integrator/series.csv three_$integrator/series.csv
  code 0 ranks "$(by_day 1 2)" run scene.yaml --out two_$integrator \
    --resume=three_$integrator/checkpoint/step_00000090.h5
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
torn_plate 0.03 0.04 "integrator: rk3" >outside.yaml
code 2 ranks 1 run outside.yaml --out outside
grep -q "crack" err || fail "a crack outside the body: $(cat err)"
echo ok
