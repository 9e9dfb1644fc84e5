#!/usr/bin/env bash
# frana check forecasts steps, the size of the files, and the time from what this machine's runs took.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
export XDG_CACHE_HOME=$work/cache # the speeds are learnt there
says() { grep -qE -- "$1" out || { cat out >&2; fail "not said: $1"; }; }
scene >full.yaml
sed -e 's/steps: 60/steps: 20/' -e 's/series_every: .*/series_every: 5/; s/fields_every: .*/fields_every: 10/' \
  -e 's/checkpoint_every: .*/checkpoint_every: 20/' full.yaml >scene.yaml

code 0 ranks 1 check scene.yaml
says '^  steps +60, .* substeps of the solid, .* sweeps over [0-9]+ directed bonds'
says '^  time +no measurement on this machine yet'
! grep -q 'substeps a step' out || fail "said of a scene whose time scales fit"
# what the run writes is what was forecast
read -r fields checkpoints < <(sed -n 's/.*: fields \([0-9.]*\) MB, 6 checkpoints \([0-9.]*\) MB,.*/\1 \2/p' out)
code 0 ranks 2 run scene.yaml --quiet
near() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a > 0.85 * b && a < 1.15 * b) }' || fail "$3: $1 MB, forecast $2 MB"; }
size() { # 5 checkpoints are kept, and one more is written before one is deleted
  find runs/scene -name "$1" -printf '%s\n' | awk '{ s += $1; n++ } END { print 1e-6 * s * (n == 5 ? 6 / 5 : 1) }'
}
near "$(size '*.hdf')" "$fields" fields
near "$(size '*.h5')" "$checkpoints" checkpoints

# the most that tables of what breaks can take: 1248 particles in 6 dumps, at the start and once as they come off, 18
# columns; 69208 bonds, 13 columns; 23 bytes a number
code 0 ranks 1 check scene.yaml
says '^ +and, if all of it breaks, at most 4\.1 MB of fragments\.csv$'
code 0 ranks 1 check scene.yaml --set output.events=true
says '^ +and, if all of it breaks, at most 4\.1 MB of fragments\.csv and 21 MB of events\.csv$'
code 0 ranks 1 check scene.yaml --set output.events=true --set output.fragments=false
says '^ +and, if all of it breaks, at most 21 MB of events\.csv$'
code 0 ranks 1 check scene.yaml --set stages.fracture.breakage=false
! grep -q 'if all of it breaks' out || fail "said of a solid of which no bond breaks"
# a bar that goes to crumbs stays below, by less than four times: numbers are shorter than the longest
cat >crumbs.yaml <<'END'
title: A bar that goes to crumbs
domain: {size: [0.016, 0.004, 0.004]}
solid:
  spacing: 1.0e-3
  materials: [{name: any, youngs_modulus: 1.0e8, density: 3000, fracture_energy: 1.0e-12}]
  bodies: [{name: bar, shape: box, low: [0, 0, 0], high: [0.016, 0.004, 0.004]}]
  loads:
END
for c in 0 1 2; do # a force that grows along each axis: all bonds are stretched
  for k in {0..15}; do
    [ $c = 0 ] || [ $k -lt 4 ] || continue
    low=(0 0 0) high=(0.016 0.004 0.004) force=(0 0 0)
    low[c]=${k}e-3 high[c]=$((k + 1))e-3 force[c]=$((k + 1))e7
    (IFS=, && echo "    - {low: [${low[*]}], high: [${high[*]}], force: [${force[*]}]}")
  done
done >>crumbs.yaml
cat >>crumbs.yaml <<'END'
stages: [{name: pull, steps: 400, time_step: 1.0e-6}]
output: {series_every: 20, fields_every: 20, checkpoint_every: 0, events: true}
END
code 0 ranks 1 check crumbs.yaml
read -r pieces unit < <(sed -n 's/.*at most \([0-9.]*\) \([kM]\)B of fragments.csv.*/\1 \2/p' out)
[ "$unit" = M ] || fail "forecast of crumbs: $(cat out)"
code 0 ranks 1 run crumbs.yaml --quiet
awk -v a="$(stat -c %s runs/crumbs/fragments.csv)" -v b="$pieces" 'BEGIN { exit !(a < 1e6 * b && a > 0.25e6 * b) }' ||
  fail "fragments.csv: $(stat -c %s runs/crumbs/fragments.csv) bytes, forecast at most $pieces MB"
# stages that last a time; the balances that are watched begin anew where the integrator changes
cat >carried.yaml <<'YAML'
title: A ball is carried along by two integrators
domain: {size: [8, 8, 8], cells: [16, 16, 16]}
fluid:
  density: 1
  viscosity: 0.1
  body_force: [1.0e-2, 0, 0]
  sides:
    {x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: periodic}, y_high: {type: periodic},
     z_low: {type: periodic}, z_high: {type: periodic}}
solid:
  materials: [{name: s, youngs_modulus: 10, density: 2}]
  bodies: [{shape: sphere, centre: [4, 4, 4], radius: 2}]
stages: [{name: a, steps: 1000, duration: 3.3}, {name: b, steps: 1000, duration: 2.1, fluid_integrator: ab2}]
YAML
code 0 ranks 1 check carried.yaml --measure
! grep warning: out || fail "a warning on a scene without fault"
says '^  a +3\.3 s, 1000 steps at most, automatic: '
says '^  steps +62 at most, '
# measured steps are kept if they take 0.2 s or more, and used by the next check
file=$XDG_CACHE_HOME/frana/speed.csv
rm -f "$file" # on a busy machine what is above may have left lines
code 0 ranks 1 check scene.yaml --measure --set stages.flow.steps=200 --set stages.settle.steps=200 \
  --set stages.fracture.steps=200
says '^  time +flow .* \(.* s a step\), settle .*, fracture .*; in all about .* on 1 rank, without output, measured now'
[ ! -e checks ] || fail "a measurement writes a folder"
[ "$(grep -vc '^#' "$file")" = 1 ] || fail "not one measurement: $(cat "$file")"
# exact numbers: 60 steps of 8192 cells at 10 ms are 82 min; twice as many ranks take half the time
awk -F, -v OFS=, '/^#/ { print; next }
  { $7 = 1e7; $8 = 0; $9 = 1; $10 = $11 = 0; $12 = 0; $6 -= 3 * 86400; print }' "$file" >edited
cp edited "$file"
code 0 ranks 1 check scene.yaml
says '^  time +more than 82 min on 1 rank: flow 82 min, interface not known, bonds '
says 'samples not known, files not known, else'
says 'from 1 run of such scenes on as many ranks on this machine, the newest 3 days old'
code 0 ranks 2 check scene.yaml
says '^  time +more than 41 min on 2 ranks'
says 'from 1 run of such scenes on any number of ranks'
# samples and files by what the scene writes: 12 samples of 8192 cells and 138416 directed bonds at 1 ms are 29 min; 6
# files of fields and 6 checkpoints at 1 ms a byte
awk -F, -v OFS=, '!/^#/ { $7 = $8 = $9 = 1; $10 = $11 = 1e6 } { print }' edited >"$file"
code 0 ranks 1 check scene.yaml
says '^  time +about .* on 1 rank: .* samples 29 min, files [0-9.]+ h, else'
near "$(sed -n 's/^  time .* files \([0-9.]*\) h, else.*/\1/p' out | awk '{ print 3.6 * $1 }')" \
  "$(awk -v a="$fields" -v b="$checkpoints" 'BEGIN { print a + b }')" "hours for files"
code 0 ranks 1 check scene.yaml --set output.series_every=60 --set output.fields_every=0
says '^  time +about .* samples 7\.3 min, files' # three, one at each end of a stage
awk -F, -v OFS=, '!/^#/ { $7 = $8 = $9 = $10 = $11 = 1 } { print }' edited >"$file"
code 0 ranks 1 check scene.yaml
says '^  time +less than 1 s on 1 rank, without start and end$'
cp edited "$file"
sed -i 's/,10000000,/,999999999,/' "$file"
code 0 ranks 1 check scene.yaml --set stages.flow.steps=5000
says '^  warning: the run takes 47[0-9] days'
code 0 ranks 2 check scene.yaml --measure --set stages.flow.time_step=1.0
says 'warning: stage flow, measured after .* is unstable in its step [0-9]+: '
says '^  time +more than'
# a cache that cannot be read or written is no reason to fail
rm -r "$XDG_CACHE_HOME" && echo text >"$XDG_CACHE_HOME"
code 0 ranks 1 check scene.yaml --measure
code 0 ranks 1 check scene.yaml
says 'no measurement on this machine yet'
! grep -q hopeless out || fail "said of a scene that can be run"

# particles without a bond have no sweep to count, and are no relaxation
cat >loose.yaml <<'END'
title: Two particles
domain: {size: [0.008, 0.004, 0.004]}
solid:
  spacing: 1.0e-3
  materials: [{name: any, youngs_modulus: 1.0e8, density: 3000}]
  bodies:
    - {shape: spheres, velocity: [1, 0, 0],
       spheres: [[1.5e-3, 1.5e-3, 1.5e-3, 4.0e-4], [6.5e-3, 1.5e-3, 1.5e-3, 4.0e-4]]}
stages: [{name: fly, steps: 40, time_step: 1.0e-6}]
END
code 0 ranks 1 check loose.yaml
says '^  steps +40, 40 substeps of the solid, 120 sweeps over 0 directed bonds$'
says '^  time +not known: particles without bonds and without a fluid are not measured in runs; .* --measure says it$'
! grep -q relaxation out || fail "relaxations where nothing relaxes"
code 0 ranks 1 check loose.yaml --measure
says '^  time +fly .* \(.* s a step\); in all about .* measured now$'

# flows that no run computes
code 0 ranks 1 check scene.yaml --set fluid.sides.x_low.bulk_velocity=1e5
says '^  warning: the Reynolds number of a cell, U d/nu, is 1\.56e\+05: the run is hopeless'
says '^  warning: stage flow: the step of .* times the fluid.s convective limit'
code 0 ranks 1 check scene.yaml --set stages.flow.time_step=1e-12
says '^  warning: stage flow: the run is hopeless: with a step of 1e-12 s the flow needs 2\.5e\+11 steps'
code 2 ranks 1 check scene.yaml --set fluid.sides.x_low.bulk_velocity=1e100
grep -q 'fluid.viscosity = .*: the Reynolds number of a cell, U d/nu, is 1.56e+100, with' err || fail "$(cat err)"
code 2 ranks 1 check scene.yaml --set fluid.sides.x_low.bulk_velocity=1e300
grep -q 'bulk_velocity = 1e300: is too large: at most 1e+150' err || { cat err; fail "a speed without a square"; }

# time scales that do not fit
code 0 ranks 1 check scene.yaml --set 'solid.materials[0].youngs_modulus=6.0e15' --set coupling.load=probe
says 'warning: stage settle: [0-9]{5} substeps a step: the run is hopeless: the step of .* s of the fluid is [0-9.e+]*'
says 'waves of .* m/s cross a spacing of .* m in .* s'
echo ok
