#!/usr/bin/env bash
# A notched plate that is opened in increments: load against opening with a peak, a row for each increment, works, the
# log, any number of ranks, a resumption; what is refused, and a load that cannot be borne.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'EOS'
title: A notched plate, opened slowly
domain: {size: [36, 20]}
solid:
  spacing: 1
  model: plane_stress
  materials:
    - {name: rock, youngs_modulus: 1, density: 1, fracture_energy: 1.0e-5}
  bodies:
    - {shape: rectangle, low: [0, 0], high: [36, 20]}
  cracks:
    - points: [[-1, 10], [12, 10]]
  constraints:
    - {low: [0, 17], high: [4, 20], directions: y, displacement: [0, 1], time: [[0, 0], [1, 1]]}
    - {low: [0, 0], high: [4, 3], directions: y, displacement: [0, -1], time: [[0, 0], [1, 1]]}
    - {low: [32, 8], high: [36, 12]}
stages:
  - {name: open, steps: 10, relax: true, increment: 8.0e-3, tolerance: 1.0e-5}
output: {series_every: 1, fields_every: 0, checkpoint_every: 5, crack: {every: 1}}
EOS
code 0 ranks 1 check scene.yaml
grep -q "open  *10 steps of 0.008 s: loads raised, relaxation and breakage in turn" out || fail "check of the stage"
code 0 ranks 1 run scene.yaml --out whole
grep -q "increment 10 to t = 0.08 s: [0-9]* bonds broken in [0-9]* rounds, [0-9]* relaxation steps" whole/run.log ||
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
awk -F, 'NR > 2 { if ($3 < last) exit 1; last = $3 } END { exit !(last > 18) }' whole/crack.csv ||
  fail "the crack does not run"
few=$(by_day 4 10)
code 0 ranks 2 run scene.yaml --out two --set stages.open.steps=$few
same <(head -n $((2 + few)) whole/series.csv) two/series.csv
code 0 ranks 1 run scene.yaml --out again --resume=whole/checkpoint/step_00000005.h5
sed -n '1,2p' whole/series.csv >tail.csv && awk -F, 'NR > 2 && $1 > 5' whole/series.csv >>tail.csv
same tail.csv again/series.csv

sed 's/displacement: \[0, -1\]/velocity: [0, -1]/' scene.yaml >refused.yaml
code 2 ranks 1 check refused.yaml
grep -q "stages\[0\].increment = 8.0e-3: solid.constraints\[1\] has a velocity" err || fail "$(cat err)"
echo ok
