#!/usr/bin/env bash
# Adaptive steps: rejected steps are repeated, in the same way on any number of ranks; a run that cannot continue
# reports which limit was exceeded.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
sides() { # sides X_LOW X_HIGH
  printf '  sides:\n    x_low: {%s}\n    x_high: {%s}\n    y_low: {type: wall}\n    y_high: {type: wall}\n' "$1" "$2"
  printf '    z_low: {type: periodic}\n    z_high: {type: periodic}\n'
}
again() { grep -o '"steps_made_again": *[0-9]*' "$1/run.json" | grep -o '[0-9]*$'; }
# done_alike SCENE RANKS... : ends with status done and with the same series on any number of ranks; the first run is
# ./one
done_alike() {
  local file=$1 n first=; shift
  for n in "$@"; do
    code 0 ranks "$n" run "$file" --out "$n-$file"
    grep -q '"status": *"done"' "$n-$file/run.json" || fail "$file on $n ranks is not done"
    [ "$(again "$n-$file")" -gt 0 ] || fail "$file on $n ranks: no step was made again"
    [ -z "$first" ] || same "$first/series.csv" "$n-$file/series.csv"
    first=${first:-$n-$file}
  done
}

# from rest to a bulk velocity in one step: the step chosen at rest exceeds the limit of the velocity after it
{
  printf 'title: jump\ndomain: {size: [0.1, 0.05, 0.05], cells: [32, 24, 16]}\n'
  printf 'fluid:\n  density: 1000\n  viscosity: 1.0e-4\n'
  printf '  driving: {type: bulk_velocity, direction: x, value: 2}\n'
  sides 'type: periodic' 'type: periodic'
  printf 'stages:\n  - {name: flow, steps: 30, time_step: auto}\noutput: {series_every: 1}\n'
} >jump
done_alike jump 1 "$(by_day 2 3)"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "cfl") c = i }
  NR > 2 && $c > sqrt(3) { print "step", $1, "cfl", $c; bad = 1 }
  END { exit bad }' 1-jump/series.csv >&2 || fail "a step beyond the limit was kept"
grep -q 'made again with .* s: convection = .* on rank' 1-jump/run.log || fail "the log does not say what was exceeded"
[ "$(awk -F, '{ print $1 }' 1-jump/series.csv | sort | uniq -d | wc -l)" = 0 ] || fail "a step has two rows"

# a plate at rest in slow flow is suddenly driven, between two kept states: the steps since the kept state are repeated
{
  printf 'title: plunge\ndomain: {size: [0.16, 0.08, 0.08], cells: [32, 16, 16]}\n'
  printf 'fluid:\n  density: 1000\n  viscosity: 1.0e-3\n'
  printf '  initial: {velocity: [0.1, 0, 0]}\n'
  sides 'type: inflow, profile: uniform, bulk_velocity: 0.1' 'type: outflow'
  printf 'solid:\n  materials: [{name: soft, youngs_modulus: 1.0e6, density: 3000, fracture_energy: 1.0e-3}]\n'
  printf '  bodies: [{name: plate, material: soft, shape: box, low: [0.06, 0.02, 0.02], high: [0.08, 0.06, 0.06]}]\n'
  printf '  constraints: [{low: [0.06, 0.02, 0.02], high: [0.065, 0.06, 0.06], velocity: [6, 0, 0],'
  printf ' time: [[0, 0], [0.07, 0], [0.0701, 1], [0.071, 0.1]]}]\n'
  printf 'coupling: {load: probe}\n'
  printf 'stages: [{name: drift, steps: 58, time_step: auto, cfl: 0.9, integrator: verlet, '
  printf 'damping_relative: 1.0e11, breakage: false}]\n'
  printf 'output: {series_every: 1}\n'
} >plunge
done_alike plunge 1 2
awk '/made again/ { split($2, step, ":"); if (step[1] % 50 > 10) late = 1 } END { exit !late }' 1-plunge/run.log ||
  fail "no step between two states kept was made again"

# two blocks that meet at 60 m/s, with a step that is stable for the bonds only
{
  printf 'title: collide\ndomain: {size: [0.2, 0.1, 0.1]}\nsolid:\n  spacing: 0.005\n'
  printf '  materials: [{name: soft, youngs_modulus: 1.0e9, density: 1000, fracture_energy: 1.0e4}]\n  bodies:\n'
  printf '    - {name: left, material: soft, shape: box, low: [0.05, 0.03, 0.03], high: [0.09, 0.06, 0.06]}\n'
  printf '    - {name: right, material: soft, shape: box, low: [0.1, 0.03, 0.03], high: [0.13, 0.06, 0.06]}\n'
  printf '  constraints: [{low: [0.12, 0.03, 0.03], high: [0.13, 0.06, 0.06], velocity: [-60, 0, 0]}]\n'
  printf 'stages: [{name: meet, steps: 40, time_step: 7.5e-6, integrator: verlet}]\noutput: {series_every: 1}\n'
} >collide
done_alike collide 1 "$(by_day 2 3)"
grep -q 'made again with 2 solid substeps instead of 1: bound by contact' 1-collide/run.log ||
  fail "contact was not what bounds"

# all bonds break at once, in a flow, with automatic steps and substeps
scene | sed -e 's/time_step: [0-9.e-]*/time_step: auto/; s/substeps: 4/substeps: auto/' \
  -e 's/fracture_energy: [0-9.e-]*/fracture_energy: 1.0e-12/' >dust.yaml
code 0 ranks "$(by_day 1 3)" run dust.yaml --out dust --set stages.fracture.steps=200
grep -q '"status": *"done"' dust/run.json || fail "dust is not done"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) { if ($i == "bonds_intact") k = i; if ($i == "bonds_broken") b = i } }
  END { exit !($b > 10 * $k) }' dust/series.csv || fail "not all has broken but what is held"

# given steps are not changed: the message has the stable step, and the kept state can be resumed with it
scene >scene.yaml
code 3 ranks 2 run scene.yaml --out given --set stages.flow.time_step=1.0e-3
grep -q 'times what diffusion would allow' err || { cat err >&2; fail "the limit is not named"; }
step=$(grep '^frana: unstable' err | sed 's/.*would allow, \([0-9.e+-]*\) s.*/\1/')
code 0 ranks 1 run scene.yaml --out given --resume --set stages.flow.time_step="$step" --set stages.settle.steps=2 \
  --set stages.fracture.steps=2
code 3 ranks 1 run scene.yaml --out coarse --set stages.settle.substeps=1 --set coupling.load=probe
n=$(grep '^frana: unstable' err | sed 's/.*: \([0-9]*\) substeps would do.*/\1/')
[ "$n" -gt 1 ] 2>/dev/null || { cat err >&2; fail "no number of substeps that would do"; }
code 0 ranks 1 run scene.yaml --out coarse --resume --set stages.settle.substeps="$n" --set stages.fracture.steps=2 \
  --set coupling.load=probe

# no step is stable: the pressure overflows
sed 's/value: 2/value: 4.0e4/; s/density: 1000$/density: 1.0e300/' jump >hopeless
code 3 ranks 2 run hopeless --out hopeless.out
[ "$(grep -c 'made again' hopeless.out/run.log)" -ge 5 ] || fail "shorter steps were not tried"
[ -f hopeless.out/checkpoint/latest ] || fail "the last good state was not kept"
# cells so small that the automatic step is 0: it cannot be made shorter
sed 's/size: [^]]*\]/size: [1.0e-200, 5.0e-201, 5.0e-201]/' jump >small
code 3 timeout 60 mpiexec -n 1 "$frana" run small --out small.out
grep -q 'no step is short enough for diffusion: its limit is 0 s' err ||
  { cat err >&2; fail "a limit of 0 is not told"; }
code 0 ranks 1 check small
grep -q "warning: stage [a-z]*: the fluid's viscous limit is 0 s, so no step is stable" out ||
  { cat out >&2; fail "frana check does not warn of a limit of 0"; }
echo ok
