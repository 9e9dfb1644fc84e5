#!/usr/bin/env bash
# frana permeability --stepped gives a symmetric tensor on any number of ranks, goes on where it was stopped, and
# refuses what it cannot measure. A stage that waits for a steady permeability ends at the same step when it is resumed.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
two_spheres 90 >scene.yaml

# the tensor, by one command; a second call makes no run again
code 0 ranks 1 permeability scene.yaml --stepped --out one
for pair in xy:yx xz:zx yz:zy; do
  close "$(value one "k_${pair%:*}")" "$(value one "k_${pair#*:}")" 0.003
done
awk -v a="$(value one asymmetry)" 'BEGIN { exit !(a >= 0 && a < 1e-4) }' || fail "asymmetry $(value one asymmetry)"
[ "$(value one steady_x)$(value one steady_y)$(value one steady_z)" = 111 ] || fail "not all steady"
close "$(value one k_xx_md)" "$(awk -v k="$(value one k_xx)" 'BEGIN { printf "%.15g", k / 9.869233e-16 }')" 1e-12
# the trace is that of the principal values, the first of which is the largest
close "$(awk -v a="$(value one principal_1)" -v b="$(value one principal_2)" -v c="$(value one principal_3)" \
  'BEGIN { if (a < b || b < c) print 0; else printf "%.15g", a + b + c }')" \
  "$(awk -v a="$(value one k_xx)" -v b="$(value one k_yy)" -v c="$(value one k_zz)" \
    'BEGIN { printf "%.15g", a + b + c }')" 1e-12
grep -q 'Principal values' one/permeability.txt || fail "no principal values in the text"
touch -d '2001-01-01' one/x/series.csv
code 0 ranks 1 permeability scene.yaml --stepped --out one
[ "$(stat -c %Y one/x/series.csv)" -lt 1000000000 ] || fail "a run that was done was made again"
code 4 ranks 1 permeability scene.yaml --stepped --out one --set fluid.viscosity=2
grep -q 'holds a run of another scene' err || fail "another scene's folder is not refused"
code 0 ranks 1 permeability scene.yaml --stepped --out one --set fluid.viscosity=2 --fresh
close "$(value one k_xx)" "$(value one k_yy)" 0.1

# along (1, 1, 0) the permeability is e K e
code 0 ranks 1 run scene.yaml --out slanted --set 'stages.flow.until={change: 1.0e-6}'
grep -q 'measured along (' slanted/run.log || fail "the log does not name the direction"
code 0 ranks "$(by_day 2 3)" permeability scene.yaml --stepped --out three --set 'stages.flow.until={change: 1.0e-6}'
eke=$(awk -v a="$(value three k_xx)" -v b="$(value three k_yy)" -v c="$(value three k_xy)" -v d="$(value three k_yx)" \
  'BEGIN { printf "%.15g", 0.5 * (a + b + c + d) }')
close "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "permeability") c = i } END { print $c }' \
  slanted/series.csv)" "$eke" 1e-5

# stopped by its limit of time, and called again
got=75
for limit in "--max-wall 0.2" "--max-wall 0.4" ""; do
  [ "$got" = 75 ] || break
  got=0
  # shellcheck disable=SC2086 # two words
  ranks 2 permeability scene.yaml --stepped --out stopped --set 'stages.flow.until={change: 1.0e-6}' $limit \
    >out 2>err || got=$?
done
[ "$got" = 0 ] || { cat out err >&2; fail "exit code $got after it was stopped"; }
for q in k_xx k_yy k_zz steps_x steps_z; do close "$(value stopped $q)" "$(value three $q)" 1e-10; done

# a stage that waits: resumed within a window it ends at the same step; the next stage follows
sed -e 's/along: \[1, 1, 0\]/direction: z/' -e '/name: flow/s/}$/, until: {change: 1.0e-4, window: 40}}/' \
  -e '/name: flow/a\  - {name: after, steps: 30, cfl: 1, solid: rigid}' scene.yaml >until.yaml
code 0 ranks 2 run until.yaml --out whole
grep -q 'stage flow: steady after [0-9]* steps' whole/run.log || fail "no sentence on the steady end"
for n in 1 $(by_day "" 2); do
  code 0 ranks $n run until.yaml --out "again$n" --resume=whole/checkpoint/stage_flow.h5
  grep -q 'stage after: 30 steps' "again$n/run.log" || fail "the stage after is not begun"
done
ended=$(sed -n 's/.*steady after \([0-9]*\) steps.*/\1/p' whole/run.log)
if [ "$((ended % 40))" != 0 ] || [ "$ended" -ge 2000 ]; then fail "steady after $ended steps"; fi
code 0 ranks 1 run until.yaml --out once --set stages.flow.steps=110 --set stages.after.steps=0
grep -q 'warning: stage flow: not steady after all its 110 steps' once/run.log || fail "the upper bound is not said"
code 0 ranks 1 run until.yaml --out short --set stages.flow.steps=30 --set stages.after.steps=0
grep -q 'not steady after all its 30 steps.*too few windows of 40 steps' short/run.log || fail "a stage below a window"
code 0 ranks "$(by_day 1 3)" run until.yaml --out middle --resume=once/checkpoint/stage_flow.h5
grep -q "steady after $ended steps" middle/run.log || fail "resumed in the middle, it ends elsewhere"
same <(sed -n '1,2p' whole/series.csv && awk -F, 'NR > 2 && $1 > 110' whole/series.csv) middle/series.csv

# slices and sub-volumes at the end of each stage; the largest sub-volume is the box
grep -c . whole/slices.csv | grep -qx $((2 + 2 * 36)) || fail "$(grep -c . whole/slices.csv) lines of slices.csv"
column() { awk -F, -v q="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == q) c = i } END { print $c }' "$1"; }
close "$(column whole/rev.csv porosity_mean)" "$(column whole/series.csv porosity)" 1e-12
close "$(column whole/rev.csv specific_surface_mean)" "$(column whole/series.csv specific_surface)" 1e-12
close "$(column whole/series.csv permeability_md)" "$(column whole/series.csv permeability |
  awk '{ printf "%.15g", $1 / 9.869233e-16 }')" 1e-12
awk -F, 'NR > 2 && $6 + 0 > 0 && $6 + 0 < 1 { n++ } END { exit !n }' whole/slices.csv || fail "porosities of slices"

# sides of given pressure: half a sphere at either end of x
sed -e '/driving/d' -e 's/x_low: .*/x_low: {type: pressure, pressure: 1.0e-6}/' \
  -e 's/x_high: .*/x_high: {type: pressure}/' scene.yaml >sides.yaml
code 0 ranks 2 permeability sides.yaml --stepped --out sides
close "$(value sides k_zz)" "$(value three k_zz)" 0.2
grep -q 'stood at the ends of each direction in turn' sides/permeability.txt || fail "the sides are not explained"
sed -e 's/y_low: .*/y_low: {type: wall}/' -e 's/y_high: .*/y_high: {type: wall}/' sides.yaml >walls.yaml
code 0 ranks 1 permeability walls.yaml --stepped --out walls
grep -q 'No principal values' walls/permeability.txt || fail "principal values of parts that were not measured"
[ "$(value walls k_yx)" = nan ] || fail "k_yx = $(value walls k_yx) across walls"

# refused: sentence, and what is set
refused() {
  local sentence=$1; shift
  code 2 ranks 1 "$@" --out refused
  grep -qF "$sentence" err || { cat err >&2; fail "not said: $sentence"; }
  [ ! -e refused ] || fail "a folder was made: $sentence"
}
z='fluid.driving={type: pressure_gradient, direction: z, value: 1}'
refused "nothing drives the fluid along x: no gradient and no body force points along it" run scene.yaml --set "$z" \
  --set coupling.medium.direction=x
refused "nothing drives the fluid along x: no gradient and no body force points along it" run scene.yaml \
  --set 'fluid.driving={type: none}' --set 'stages.flow.until={}'
refused "nothing drives the fluid along y: its sides let nothing through" run walls.yaml \
  --set coupling.medium.direction=y
refused "nothing drives the fluid along x: its sides have the same pressure" run sides.yaml \
  --set fluid.sides.x_low.pressure=0 --set coupling.medium.direction=x
refused "the fluid is driven along x too: a permeability along y alone cannot be measured" run scene.yaml \
  --set coupling.medium.direction=y
refused "the medium's box must be the whole period along x" run scene.yaml --set 'coupling.medium.low=[0.25, 0, 0]' \
  --set coupling.medium.direction=driving
refused "no way through the medium along z that the cells resolve" run scene.yaml --set "$z" \
  --set 'stages.flow.until={}' --set 'solid.bodies=[{shape: box, low: [0, 0, 0.25], high: [1, 1, 0.5]}]'
refused "the medium's box holds no fluid" run scene.yaml --set "$z" --set 'stages.flow.until={}' \
  --set 'solid.bodies=[{shape: box, low: [0, 0, 0], high: [1, 1, 1]}]'
refused "no way through the medium along z that the cells resolve" permeability scene.yaml --stepped \
  --set 'solid.bodies=[{shape: box, low: [0, 0, 0.25], high: [1, 1, 0.5]}]'
refused "nothing drives the fluid: give a gradient" permeability scene.yaml --set 'fluid.driving={type: none}'
refused "x_low is in the way" permeability sides.yaml --set 'fluid.sides.x_low={type: inflow, bulk_velocity: 1}' \
  --set 'fluid.sides.x_high={type: outflow}'
refused "its sides have the same pressure" permeability sides.yaml --set fluid.sides.x_low.pressure=0
refused "a driving or a body force: leave one out" permeability sides.yaml --set 'fluid.body_force=[0, 0, 1]'

# not asked for: no number, and one sentence
code 0 ranks 1 run scene.yaml --out idle --set 'fluid.driving={type: none}' --set stages.flow.steps=2
grep -q 'permeability is not measured: nothing drives the fluid along x' idle/run.log || fail "the log does not say why"
[ "$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "permeability") c = i } END { print $c }' \
  idle/series.csv)" = nan ] || fail "a permeability without a driving"
echo ok
