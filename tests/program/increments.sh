#!/usr/bin/env bash
# A notched plate that is opened in increments: load against opening with a peak, a row for each increment, works, the
# log, any number of ranks, a resumption; what is refused, and a load that cannot be borne.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'EOS'
title: A notched plate, opened slowly
domain: {size: [22, 12]}
solid:
  spacing: 1
  model: plane_stress
  materials:
    - {name: rock, youngs_modulus: 1, density: 1, fracture_energy: 1.0e-5}
  bodies:
    - {shape: rectangle, low: [0, 0], high: [22, 12]}
  cracks:
    - points: [[-1, 6], [7, 6]]
  constraints:
    - {low: [0, 9], high: [4, 12], directions: y, displacement: [0, 1], time: [[0, 0], [1, 1]]}
    - {low: [0, 0], high: [4, 3], directions: y, displacement: [0, -1], time: [[0, 0], [1, 1]]}
    - {low: [18, 4], high: [22, 8]}
stages:
  - {name: open, steps: 10, relax: true, increment: 5.0e-3, tolerance: 1.0e-5}
output: {series_every: 1, fields_every: 0, checkpoint_every: 8, crack: {every: 1}}
EOS
code 0 ranks 1 check scene.yaml
grep -q "open  *10 steps of 0.005 s: loads raised, relaxation and breakage in turn" out || fail "check of the stage"
code 0 ranks 1 run scene.yaml --out whole
grep -q "increment 10 to t = 0.05 s: [0-9]* bonds broken in [0-9]* rounds, [0-9]* relaxation steps" whole/run.log ||
  fail "the log does not say what broke"
[ "$(wc -l <whole/series.csv)" = 12 ] || fail "not a row for each increment"
# the load rises in proportion to the opening, has a peak, and falls
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 && $at["index"] == 0 {
    n++; f = $at["force_y"]
    if (n == 1) first = f
    if (n == 2) second = f
    if (f > most) { most = f; when = n } }
  END { print "peak", most, "in increment", when, "last", f
    exit !(second / first > 1.99 && second / first < 2.01 && when > 2 && when < 9 && f < 0.8 * most) }' \
  whole/reactions.csv || fail "load against opening"
# works: all of it is strain before a bond breaks, and later what strain and broken bonds hold and relaxations took
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 { w = $at["e_constraint"]; e = $at["e_strain"] + $at["e_fracture"] + $at["e_contact"]; f = $at["e_fracture"]
    if (f == 0 && (e / w - 1) ^ 2 > 1e-6) { print "elastic", e / w; exit 1 }
    d = $at["e_damped"]
    if (e + d > 1.001 * w || e + d < 0.999 * w || d < last) { print "row", NR, e / w, d / w; exit 1 }
    last = d }
  END { print "of the work", e / w, "is held, by broken bonds", f / w; exit !(f > 0.2 * w) }' \
  whole/series.csv || fail "works"
awk -F, 'NR > 2 { if ($3 < last) exit 1; last = $3 } END { exit !(last > 11) }' whole/crack.csv ||
  fail "the crack does not run"
few=$(by_day 4 10)
code 0 ranks 2 run scene.yaml --out two --set stages.open.steps=$few
same <(head -n $((2 + few)) whole/series.csv) two/series.csv
code 0 ranks 1 run scene.yaml --out again --resume=whole/checkpoint/step_00000008.h5
sed -n '1,2p' whole/series.csv >tail.csv && awk -F, 'NR > 2 && $1 > 8' whole/series.csv >>tail.csv
same tail.csv again/series.csv

sed 's/displacement: \[0, -1\]/velocity: [0, -1]/' scene.yaml >refused.yaml
code 2 ranks 1 check refused.yaml
grep -q "stages\[0\].increment = 5.0e-3: solid.constraints\[1\] has a velocity" err || fail "$(cat err)"

# two bodies: one rests upon the other by its weight; one is driven into the other from a spacing apart
cat >bodies.yaml <<'EOS'
title: A body on a body
domain: {size: [0.02, 0.03]}
solid:
  spacing: 1.0e-3
  model: plane_stress
  materials: [{name: soft, youngs_modulus: 1.0e6, density: 1000}]
  bodies:
    - {name: below, shape: rectangle, low: [0.004, 0.002], high: [0.016, 0.010]}
    - {name: above, shape: rectangle, low: [0.005, 0.010], high: [0.015, 0.018]}
  constraints: [{low: [0.004, 0.002], high: [0.016, 0.003]}]
  body_force: [0, -9.81]
stages: [{name: settle, steps: 1, relax: true}]
output: {series_every: 1, fields_every: 0, checkpoint_every: 0}
EOS
# last FILE COLUMN KEY VALUE: the column of the last row in which the column KEY has this value
last() {
  awk -F, -v column="$2" -v key="$3" -v value="$4" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 && $at[key] == value { v = $at[column] } END { print v }' "$1"
}
near() { awk -v a="$1" -v b="$2" -v of="$3" 'BEGIN { exit !(a > b - of && a < b + of) }' || fail "$4: $1, not $2"; }
for n in 1 2; do
  code 0 ranks "$n" run bodies.yaml --out "weight_$n" --quiet
  near "$(last "weight_$n/reactions.csv" force_y index 0)" 1.72656 2e-5 "the support of two bodies"
  near "$(last "weight_$n/bodies.csv" contact_y body 1)" 0.7848 2e-5 "the contact under a body"
done
drive=(--set 'solid.body_force=[0, 0]' --set 'solid.bodies.above.low=[0.005, 0.011]'
  --set 'solid.bodies.above.high=[0.015, 0.019]'
  --set 'solid.constraints=[{low: [0.004, 0.002], high: [0.016, 0.003]},
  {low: [0.005, 0.011], high: [0.015, 0.019], displacement: [0, -0.0012], time: [[0, 0], [1, 1]]}]')
code 0 ranks 1 run bodies.yaml --out drive --quiet "${drive[@]}" --set stages.settle.increment=0.5 \
  --set stages.settle.steps=2
code 0 ranks 1 run bodies.yaml --out slow --quiet "${drive[@]}" --set stages.settle.increment=0.125 \
  --set stages.settle.steps=8
slow=$(last slow/reactions.csv force_y index 1)
awk -v f="$slow" 'BEGIN { exit !(f < -200 && f > -400) }' || fail "bodies that are pressed together: $slow N"
near "$(last drive/reactions.csv force_y index 1)" "$slow" 3 "bodies that meet within an increment"

# a relaxation takes no time, also before a stage that has steps
code 0 ranks 1 run bodies.yaml --out time --quiet --set 'stages=[
  {name: rest, steps: 5, relax: true, tolerance: 1.0e-3}, {name: go, steps: 2}]' --set output.series_every=1
awk -F, '$1 == 5 { at = $2 } $1 == 7 { steps = $2 / $3 } END { exit !(at == 0 && steps > 1.999 && steps < 2.001) }' \
  time/series.csv || fail "a relaxation takes time"
echo ok
