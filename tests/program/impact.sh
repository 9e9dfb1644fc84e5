#!/usr/bin/env bash
# Bodies that move at the start: bodies.csv, momentum, contact's energy, on any number of ranks, after a resumption, and
# in a fluid: a body that is thrown into a fluid at rest feels what one at rest feels in a fluid that moves.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'EOS'
title: A ball breaks a slab
domain: {size: [0.024, 0.024, 0.024]}
solid:
  spacing: 1.0e-3
  materials:
    - {name: rock, youngs_modulus: 5.0e10, density: 2500, fracture_energy: 40}
  bodies:
    - {name: slab, shape: box, low: [0.004, 0.004, 0.006], high: [0.02, 0.02, 0.01]}
    - {name: ball, shape: sphere, centre: [0.0123, 0.0119, 0.0152], radius: 0.004, velocity: [5, 0, -60]}
  loads:
    - {low: [0.004, 0.004, 0.006], high: [0.02, 0.02, 0.01], force: [0, 0, 1.0e6]}
  contact: {radius: 1.4}
stages:
  - {name: impact, steps: 300, integrator: rk3, safety: 0.3}
output: {series_every: 10, fields_every: 0, checkpoint_every: 150}
EOS
code 0 ranks 1 check scene.yaml
grep -q "moving     ball, at the start with (5, 0, -60) m/s" out || fail "check does not say what moves"
! grep -q warning out || fail "check warns of RK3"
code 0 ranks 1 check scene.yaml --set stages.impact.integrator=verlet --set stages.impact.time_step=2.1e-7 \
  --set stages.impact.substeps=1
! grep -q warning out || fail "check warns of contact, which is implicit"
code 0 ranks 1 run scene.yaml --out whole
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 {
    held = $at["e_kinetic_solid"] + $at["e_strain"] + $at["e_damped"] + $at["e_fracture"] - $at["work_load"]
    e = held + $at["e_contact"]
    if (NR == 3) { first = e; least = held; px = $at["momentum_x"]; pz = $at["momentum_z"] - $at["t"] * $at["given_z"] }
    if (held < least) least = held
    off = e / first - 1; if (off < 0) off = -off; if (off > worst) worst = off
    bx = $at["momentum_x"] / px - 1; bz = ($at["momentum_z"] - $at["t"] * $at["given_z"]) / pz - 1
    if (bx * bx > 1e-20 || bz * bz > 1e-20) { print "momentum off by", bx, bz; exit 1 }
    broken = $at["bonds_broken"]; given = $at["given_z"] }
  END {
    print "energy off by", worst, "of which contact holds", 1 - least / first, "bonds broken", broken, "given", given
    exit !(worst < 1e-3 && 1 - least / first > 4 * worst && broken > 1000 && given / 1.024 > 0.9999999 &&
      given / 1.024 < 1.0000001) }' whole/series.csv || fail "the balance of energy or momentum"
# the bodies' momenta add up to the solid's, contact's forces to 0, and a force changes the momentum
awk -F, 'FNR == 1 { for (i = 1; i <= NF; i++) at[FILENAME, $i] = i; next }
  FNR == 2 { next }
  FILENAME ~ /series/ { p[$1] = $at[FILENAME, "momentum_z"]; next }
  { sum[$1] += $at[FILENAME, "momentum_z"]; c = $at[FILENAME, "contact_z"]; all[$1] += c
    if ($at[FILENAME, "body"] == 1) ball = c; if (ball > most) most = ball
    if ($1 == 0 && $at[FILENAME, "body"] == 1) v = $at[FILENAME, "momentum_z"] / $at[FILENAME, "mass"] }
  END {
    for (k in p)
      if ((sum[k] - p[k])^2 > 1e-24 || all[k]^2 > 1e-20 * most^2) { print k, sum[k], p[k], all[k]; exit 1 }
    exit !(most > 100 && (v + 60)^2 < 1e-18) }' whole/series.csv whole/bodies.csv || fail "bodies.csv"
code 0 ranks 2 run scene.yaml --out two
same whole/series.csv two/series.csv
echo step_00000150.h5 >two/checkpoint/latest
code 0 ranks 1 run scene.yaml --out two --resume
grep -q '"resumed_at_step": *150' two/run.json || fail "not resumed at step 150"
same whole/series.csv two/series.csv
[ "$(cut -d, -f1,3 whole/bodies.csv)" = "$(cut -d, -f1,3 two/bodies.csv)" ] || fail "bodies.csv after a resumption"

# Galilei: body and fluid with one velocity more or less
sed -e 's/steps: 4000/steps: 40/; s/title: .*/title: Thrown into a fluid/' -e 's/cells: .*/cells: [16, 16, 16]}/' \
  -e 's/probes: .*/fields_every: 0/' -e 's/series_every: 20/series_every: 4/' \
  "$source/cases/verification/rest_and_galilean/free.yaml" >fluid.yaml
for load in reaction probe; do
  code 0 ranks "$(by_day 1 2)" run fluid.yaml --out "rest_$load" --set coupling.load=$load
  code 0 ranks 2 run fluid.yaml --out "thrown_$load" --set coupling.load=$load \
    --set 'fluid.initial.velocity=[0, 0, 0]' --set 'solid.bodies[0].velocity=[-1, -0.5, -0.25]'
  awk -F, 'FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; file++; next }
    FNR == 2 { next }
    file == 1 { f[$1] = $at["load_x"]; p[$1] = $at["momentum_x"]; next }
    { d = $at["load_x"] - f[$1]; big = f[$1] > big ? f[$1] : big; off = d^2 > off ? d^2 : off
      m = $at["momentum_x"]; moved = p[$1] }
    END { print "load off by", sqrt(off) / big, "momentum", moved, m; exit !(big > 0 && sqrt(off) < 0.02 * big) }' \
    "rest_$load/series.csv" "thrown_$load/series.csv" || fail "load $load: not the same in a moving frame"
done
