#!/usr/bin/env bash
# Stopped while the solid is set up, in a relaxation, in an increment, in a step of many substeps, in a sample of the
# intrinsic permeability: within seconds, with a checkpoint from which it goes on to the same result.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# stopped SECONDS ARGUMENTS...: frana run, stopped by SIGTERM once $when succeeds; ends with 75 in so many seconds
stopped() {
  local most=$1 got=0 from; shift
  ranks 1 run "$@" >out 2>err &
  local pid=$!
  await "$pid" $when "$pid" || { cat out err; fail "ended before it was stopped: $*"; }
  kill -TERM "$(pgrep -P "$pid" -x "$(basename "$frana")" || echo "$pid")"
  from=$SECONDS
  wait "$pid" || got=$?
  [ $got = 75 ] || { cat out err; fail "exit code $got, not 75: $*"; }
  [ $((SECONDS - from)) -le "$most" ] || fail "took $((SECONDS - from)) s to stop: $*"
}
catches() { # whether the process handles SIGTERM
  local p caught
  p=$(pgrep -P "$1" -x "$(basename "$frana")" || echo "$1")
  caught=$(awk '/^SigCgt/ { print $2 }' "/proc/$p/status" 2>/dev/null) && [ -n "$caught" ] &&
    ((0x$caught >> 14 & 1))
}
said() { grep -q "$1" run/run.log || fail "log: $(tail -1 run/run.log)"; }
steps() { grep -qs '^stage ' run/run.log; }
cat >sag.yaml <<'EOS'
title: a bar that sags
domain: {size: [0.2, 0.02, 0.02]}
solid:
  spacing: 1.0e-3
  materials: [{name: s, youngs_modulus: 1.0e9, density: 2000}]
  bodies: [{shape: box, low: [0.001, 0.005, 0.005], high: [0.041, 0.010, 0.010]}]
  body_force: [0, -9.81, 0]
  constraints:
    - {low: [0, 0, 0], high: [0.0045, 0.02, 0.02]}
stages: [{name: sag, steps: 1, relax: true, tolerance: 1.0e-7}]
output: {fields_every: 0, series_every: 1, checkpoint_every: 0, probes: {at: [[0.04, 0.008, 0.008]], every: 1}}
EOS
code 0 ranks 1 run sag.yaml --out whole
when=steps
stopped 5 sag.yaml --out run
said 'stopped by SIGTERM within step 1, with a checkpoint of step 0'
[ -f run/checkpoint/step_00000000.h5 ] || fail "no checkpoint of a relaxation that was stopped"
code 0 ranks "$(by_day 1 2)" run sag.yaml --out run --resume
bent() { awk -F, '
  NR == 1 { for (i = 1; i <= NF; i++) if ($i == "displacement_y") y = i } 
  END { print $y }' "$1"/probes.csv; }
echo "$(bent whole) $(bent run)" | awk '{ print "bent by", $1, "and in two parts by", $2, "m"
  exit !($1 < -1e-7 && ($2 / $1 - 1) ^ 2 < 1e-8) }' || fail "a relaxation that was stopped leads elsewhere"

# in a step of 10^6 substeps: the state before it
sed -e 's/^stages.*/stages: [{name: move, steps: 3, time_step: 1.0e-2, substeps: 1000000}]/' sag.yaml >move.yaml
rm -rf run
stopped 5 move.yaml --out run
said 'stopped by SIGTERM within step 1, with a checkpoint of step 0'

# while 400,000 particles are set up
rm -rf run
when=catches
stopped 3 sag.yaml --out run --set solid.spacing=2.5e-4
grep -q 'stopped by SIGTERM during the set-up: no step is lost' err || fail "no sentence: $(cat err)"
[ ! -e run/checkpoint/latest ] || fail "a checkpoint of no step"

# in increments with breakage: the rest is the same
cat >open.yaml <<'EOS'
title: A notched plate, opened slowly
domain: {size: [24, 16]}
solid:
  spacing: 1
  model: plane_stress
  materials: [{name: rock, youngs_modulus: 1, density: 1, fracture_energy: 1.0e-5}]
  bodies: [{shape: rectangle, low: [0, 0], high: [24, 16]}]
  cracks: [{points: [[-1, 8], [9, 8]]}]
  constraints:
    - {low: [0, 13], high: [4, 16], directions: y, displacement: [0, 1], time: [[0, 0], [1, 1]]}
    - {low: [0, 0], high: [4, 3], directions: y, displacement: [0, -1], time: [[0, 0], [1, 1]]}
    - {low: [20, 6], high: [24, 10]}
stages: [{name: open, steps: 3, relax: true, increment: 2.5e-2, tolerance: 1.0e-6}]
output: {series_every: 1, fields_every: 0, checkpoint_every: 0}
EOS
code 0 ranks 1 run open.yaml --out whole_open
second() { grep -qs 'increment 2 to' run/run.log; }
rm -rf run
when=second
stopped 5 open.yaml --out run
said 'stopped by SIGTERM within step 3, with a checkpoint of step 2'
code 0 ranks 1 run open.yaml --out run --resume
same whole_open/series.csv run/series.csv || fail "increments that were stopped lead elsewhere"

# in the sample of the intrinsic permeability at step 2: its row is written when the run goes on
cat >spheres.yaml <<EOS
title: A long sample of the intrinsic permeability
domain: {size: [0.06, 0.06, 0.06], cells: [36, 36, 36]}
fluid:
  density: 1000
  viscosity: 1.0e-6
  driving: {type: pressure_gradient, value: 1}
  sides:
$(periodic {x,y,z}_{low,high})
solid:
  materials: [{name: soft, youngs_modulus: 1.0e4, density: 1000, horizon_ratio: 2}]
  bodies:
    - shape: spheres
      spheres: [[0.013, 0.014, 0.011, 0.012], [0.045, 0.017, 0.043, 0.0135], [0.016, 0.043, 0.045, 0.0125],
                [0.044, 0.044, 0.014, 0.0135], [0.03, 0.03, 0.03, 0.008]]
stages: [{name: flow, steps: 3, solid: rigid, time_step: 1.0e-3}]
output: {series_every: 1, fields_every: 0, checkpoint_every: 0, permeability_every: 2}
EOS
code 0 ranks 1 run spheres.yaml --out whole_spheres
sampled() { grep -qs '^2,' run/series.csv; }
rm -rf run
when=sampled
stopped 5 spheres.yaml --out run
said 'stopped by SIGTERM after step 2, with a checkpoint'
grep -q 'the sample of the intrinsic permeability at step 2 is given up' run/run.log ||
  fail "the sample was not stopped"
! grep -q '^[0-9]' run/intrinsic.csv || fail "a row of a sample that was given up"
code 0 ranks 1 run spheres.yaml --out run --resume
[ "$(cut -d, -f 1-13 run/intrinsic.csv)" = "$(cut -d, -f 1-13 whole_spheres/intrinsic.csv)" ] ||
  fail "the sample that was stopped is another one: $(cat run/intrinsic.csv)"
# once more, from a checkpoint whose row is there: it is not written twice
cp -r run again
code 0 ranks 1 run spheres.yaml --out again --resume
cmp run/intrinsic.csv again/intrinsic.csv || fail "a row twice"
echo ok
