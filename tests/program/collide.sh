#!/usr/bin/env bash
# What contact and cracks will not do is said before a run; a fast body does not pass another one unseen.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >plate.yaml <<'YAML'
domain: {size: [0.02, 0.02]}
solid:
  spacing: 1.0e-3
  model: plane_stress
  materials: [{name: m, youngs_modulus: 1.0e9, density: 2000, fracture_energy: 10}]
  bodies: [{shape: rectangle, low: [0, 0], high: [0.02, 0.02]}]
  cracks: [{points: [[0, 0.0105], [0.0105, 0.0105]]}]
stages: [{name: rest, steps: 2}]
output: {fields_every: 0}
YAML
cat >bodies.yaml <<'YAML'
domain: {size: [0.03, 0.06, 0.03]}
solid:
  spacing: 1.0e-3
  materials: [{name: s, youngs_modulus: 1.0e5, density: 1000}]
  bodies:
    - {name: plate, shape: box, low: [0.010, 0.020, 0.010], high: [0.020, 0.023, 0.020]}
    - {name: ball, shape: box, low: [0.013, 0.039, 0.013], high: [0.017, 0.043, 0.017], velocity: [0, -5, 0]}
stages: [{name: hit, steps: 60, integrator: verlet}]
output: {fields_every: 0, series_every: 1, checkpoint_every: 0}
YAML
# says COUNT PATTERN SCENE [options]: so many lines of the check have the pattern, and the log has those as well
says() {
  local count=$1 pattern=$2 scene=$3; shift 3
  code 0 ranks 1 check "$scene" "$@"
  [ "$(grep -c "warning: .*$pattern" out)" = "$count" ] || { cat out >&2; fail "not $count times: $pattern"; }
  rm -rf run && code 0 ranks 1 run "$scene" --out run --quiet "$@" --set stages.0.steps=1
  [ "$(grep -c "warning: .*$pattern" run/run.log)" = "$count" ] || fail "not $count times in the log: $pattern"
}
# a crack that ends on the eleventh particle of a row, and one between two rows
says 1 'leave 11 particles without a bond' plate.yaml
says 0 'without a bond' plate.yaml --set solid.cracks.0.points='[[0, 0.01], [0.0105, 0.01]]'
# faces of 10 x 10 and 4 x 4 particles a spacing apart: 16 pairs, and 64 at the root of two
near=(--set solid.bodies.1.low='[0.013, 0.023, 0.013]' --set solid.bodies.1.high='[0.017, 0.027, 0.017]')
says 1 '80 pairs of particles .* closest 0.001 m apart: .* solid.contact.radius: 1 ' bodies.yaml "${near[@]}" \
  --set solid.contact.radius=1.5
says 0 'are closer than the contact radius' bodies.yaml "${near[@]}"
# contact of the default stiffness holds 7.4 m/s; of nine times that, three times as much
says 0 'if they collide' bodies.yaml
says 1 'differ by 20 m/s: if they collide' bodies.yaml --set solid.bodies.1.velocity='[0, -20, 0]'
says 0 'if they collide' bodies.yaml --set solid.bodies.1.velocity='[0, -20, 0]' --set solid.contact.stiffness=135
# A step of 20 spacings, from one side of the plate to the other: the bodies meet, and the energies close.
code 0 ranks 2 run bodies.yaml --out fast --quiet --set solid.bodies.1.velocity='[0, -100, 0]' \
  --set solid.contact.stiffness=20000 --set stages.0.steps=4
grep -q 'solid substeps, bound by contact' fast/run.log || fail "the step is not divided"
awk -F, '{ gsub(/ /, "") } NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } $1 !~ /^[0-9]/ { next }
  { s = $at["e_kinetic_solid"] + $at["e_strain"] + $at["e_contact"] + $at["e_integrator"]
    if (!n++) first = s; strain = $at["e_strain"] > strain ? $at["e_strain"] : strain
    off = s - first > 0 ? s - first : first - s; most = off > most ? off : most }
  END { printf "strain energy %.3g, off by %.3g of %.3g J\n", strain, most, first
        exit !(strain > 0.01 * first && most < 0.05 * first) }' fast/series.csv || fail "the bodies have not met"
# Bodies that touch at the start, or where a run begins with the checkpoint of another: their first row has the force.
touch=("${near[@]}" --set solid.bodies.1.velocity='[0, 0, 0]' --set solid.contact.radius=1.5
  --set output.checkpoint_every=1 --set stages.0.time_step=1e-9)
code 0 ranks 2 run bodies.yaml --out touch --quiet "${touch[@]}" --set stages.0.steps=1
code 0 ranks 1 run bodies.yaml --out begun --quiet "${touch[@]}" --set stages.0.steps=2 \
  --resume=touch/checkpoint/step_00000001.h5
for rows in touch begun; do
  awk -F, -v rows=$rows 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR > 2 { force[++n] = $at["contact_y"] }
    END { printf "%s: contact pushes with %.6g N, then with %.6g N\n", rows, force[1], force[3]
          exit !(force[1] != 0 && (force[1] - force[3])^2 < 1e-8 * force[3]^2) }' $rows/bodies.csv ||
    fail "contact in the first row of $rows/bodies.csv"
done
echo "bodies and cracks are looked at"
