#!/usr/bin/env bash
# fluid_probes.csv: its format; the same on any number of ranks; continued by a resumed run; an oscillating gradient
# keeps its phase.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'END'
title: Vortices carried along a channel of slip, with an oscillating gradient
domain: {size: [0.2, 0.1, 0.1], cells: [16, 8, 12]}
fluid:
  density: 1000
  viscosity: 1.0e-4
  initial: {velocity: [0.02, 0, 0], taylor_green: {velocity: 0.1, axes: xyz}}
  sides:
    x_low: {type: periodic}
    x_high: {type: periodic}
    y_low: {type: slip}
    y_high: {type: slip}
    z_low: {type: periodic}
    z_high: {type: periodic}
  driving: {type: pressure_gradient, value: 50, frequency: 2}
stages: [{name: run, steps: 40, time_step: 5.0e-3}]
output:
  series_every: 10
  checkpoint_every: 16
  fluid_probes:
    at: [[0.05, 0.025, 0.05], [0.2, 0.1, 0.1]]
    lines: [{from: [0, 0, 0.03], to: [0.2, 0.1, 0.03], points: 5}]
    every: 4
END
code 0 ranks 1 run scene.yaml --out whole
[ "$(wc -l <whole/fluid_probes.csv)" = 79 ] || fail "not 11 times 7 rows in fluid_probes.csv"
[ "$(sed -n 2p whole/fluid_probes.csv)" = '#1,s,1,m,m,m,m/s,m/s,m/s,Pa' ] || fail "$(sed -n 2p whole/fluid_probes.csv)"
[ "$(sed -n 7p whole/fluid_probes.csv | cut -d, -f1-6)" = 0,0,4,0.1,0.05,0.03 ] || fail "the third place of the line"
awk -F, 'NR > 2 && $3 == 0 { if ($10 * $10 > most) most = $10 * $10 }
  END { exit !(most > 1) }' whole/fluid_probes.csv || fail "p is 0"
code 0 ranks "$(by_day 2 3)" run scene.yaml --out ranks
same whole/fluid_probes.csv ranks/fluid_probes.csv
code 0 ranks 2 run scene.yaml --out stopped --set stages.run.steps=29
echo step_00000016.h5 >stopped/checkpoint/latest
code 0 ranks 1 run scene.yaml --out stopped --resume
same whole/fluid_probes.csv stopped/fluid_probes.csv
same whole/series.csv stopped/series.csv
# a flow is the same to the bit whether it is looked at or not, also where ghosts follow from continuity at a free side
side=fluid.sides
free=(--set $side.x_low='{type: pressure, pressure: 50}' --set $side.x_high='{type: pressure}' --set fluid.initial='{}'
  --set fluid.driving='{type: none}' --set $side.z_low='{type: wall}' --set $side.z_high='{type: wall}'
  --set fluid.viscosity=1.0e-3 --set output.series_every=1)
code 0 ranks 1 run scene.yaml --out seen "${free[@]}"
code 0 ranks 1 run scene.yaml --out unseen "${free[@]}" --set output.fluid_probes.every=1000
cmp seen/series.csv unseen/series.csv || fail "fluid probes change the flow"
code 2 ranks 2 run scene.yaml --out far --set output.fluid_probes.at='[[0.2, 0.11, 0]]'
grep -q "output.fluid_probes.at\[0\].*must be within the domain, 0 to 0.1 m in y" err || fail "$(cat err)"
echo ok
