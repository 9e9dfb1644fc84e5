#!/usr/bin/env bash
# A notch that fluid is pumped into, in a plate and in a block, and one that is open to a flow: the same series on other
# ranks, and resumed in the middle on another number of ranks; volumes add up; mistakes are refused with sentences.
# usage: crack_fluid.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >plate.yaml <<'E2'
title: Fluid is pumped into a notch
domain: {size: [0.04, 0.04]}
solid:
  spacing: 1.0e-3
  model: plane_strain
  thickness: 1.0e-3
  materials: [{name: rock, youngs_modulus: 2.0e10, density: 2500, fracture_energy: 50}]
  bodies: [{shape: rectangle, low: [0, 0], high: [0.04, 0.04]}]
  cracks: [{points: [[0.014, 0.02], [0.026, 0.02]]}]
  loads: [{low: [0, 0], high: [0.04, 0.001], force: [0, 1.0e3], time: [[0, 0], [1.0e-4, 1]]}]
crack_fluid:
  viscosity: 1.0e-3
  injections: [{low: [0.019, 0.017], high: [0.021, 0.023], rate: 2.0e-5, time: [[0, 0], [5.0e-5, 1]]}]
stages: [{name: pump, steps: 80, integrator: verlet, crack_fluid: true}]
output: {series_every: 10, checkpoint_every: 50, fields_every: 80}
E2
crack='[[0.005, 0.005, 0.008], [0.015, 0.005, 0.008], [0.015, 0.015, 0.008], [0.005, 0.015, 0.008]]'
given='{low: [0.008, 0.008, 0.006], high: [0.012, 0.012, 0.01], pressure: 3.0e7, time: [[0, 0], [1.0e-5, 1]]}'
sed -e 's/\[0.04, 0.04\]/[0.02, 0.02, 0.016]/g; s/  model.*//; s/  thickness.*//; s/  loads:.*//' \
  -e "s/rectangle, low: \[0, 0\]/box, low: [0, 0, 0]/; s/  cracks:.*/  cracks: [{points: $crack}]/" \
  -e "s/injections:.*/injections: [$given]/; s/steps: 80/steps: 40/; s/every: 50/every: 25/" \
  -e 's/fields_every: 80/fields_every: 0/' plate.yaml >block.yaml
# a wall between two pressures, with a notch that is open to the higher one and grows
cat >open.yaml <<'E3'
title: The flow's pressure enters a notch
domain: {size: [0.024, 0.016, 0.008], cells: [24, 16, 8]}
fluid:
  density: 1000
  viscosity: 1.0e-8
  sides:
    x_low: {type: pressure, pressure: 100}
    x_high: {type: pressure, pressure: 0}
    y_low: {type: slip}
    y_high: {type: slip}
    z_low: {type: periodic}
    z_high: {type: periodic}
solid:
  materials: [{name: rubber, youngs_modulus: 1.0e5, density: 3000, fracture_energy: 1.0e-4}]
  bodies: [{shape: box, low: [0.007, -0.003, 0], high: [0.018, 0.019, 0.008]}]
  cracks: [{points: [[0.006, 0.008, -0.001], [0.012, 0.008, -0.001], [0.012, 0.008, 0.009], [0.006, 0.008, 0.009]]}]
  constraints: [{low: [0.015, -0.003, 0], high: [0.018, 0.019, 0.008]}]
coupling: {load: probe}
crack_fluid: {least_pressure: -1.0e3, least_aperture: 5.0e-5}
stages: [{name: fill, steps: 40, time_step: 1.0e-4, integrator: verlet, damping_absolute: 200, crack_fluid: true}]
output: {series_every: 10, checkpoint_every: 20, fields_every: 0}
E3
# a slot in a block under 200 Pa all around, with 250 Pa in it; the block alone with 50 Pa in it
cat >slot.yaml <<'E4'
title: A slot in a block at rest in a still fluid
domain: {size: [0.024, 0.024, 0.008], cells: [24, 24, 8]}
fluid:
  density: 1000
  viscosity: 1.0e-8
  sides:
    x_low: {type: pressure, pressure: 200}
    x_high: {type: pressure, pressure: 200}
    y_low: {type: slip}
    y_high: {type: slip}
    z_low: {type: periodic}
    z_high: {type: periodic}
solid:
  spacing: 1.0e-3
  materials: [{name: rubber, youngs_modulus: 1.0e5, density: 3000}]
  bodies: [{shape: box, low: [0.004, 0.006, 0], high: [0.02, 0.018, 0.008]}]
  cracks: [{points: [[0.008, 0.012, -0.001], [0.016, 0.012, -0.001], [0.016, 0.012, 0.009], [0.008, 0.012, 0.009]]}]
crack_fluid:
  least_pressure: -1.0e5
  least_aperture: 5.0e-5
  injections: [{low: [0.011, 0.011, 0], high: [0.013, 0.013, 0.008], pressure: 250}]
stages: [{name: fill, steps: 260, time_step: 1.0e-4, integrator: verlet, damping_absolute: 300, crack_fluid: true}]
output: {series_every: 20, checkpoint_every: 240, fields_every: 0}
E4
sed -e '/^fluid:/,/z_high/d; s/, cells.*/, periodic: [false, false, true]}/; s/^crack_fluid:/&\n  viscosity: 1.0e-5/' \
  -e 's/pressure: 250/pressure: 50/' slot.yaml >dry_slot.yaml
# volumes_balance FILE: crack_volume - cavity_volume = injected_volume + mouth_volume, which is above 0
volumes_balance() {
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 { r = $at["volume_residual"]; v = $at["crack_volume"] + $at["injected_volume"]
      n++; last = $at["injected_volume"]
      if ("mouth_volume" in at) { v += $at["mouth_volume"]; last += $at["mouth_volume"] }
      if (r < 0) r = -r
      if (r > 1e-12 * v) exit 1 }
    END { exit !(n > 1 && last > 0) }' "$1" || fail "$1: the volumes do not add up"
}
sed -e 's/steps: 80/steps: 40/; s/every: 50/every: 20/; s/fields_every: 80/fields_every: 0/' plate.yaml >short.yaml
# stretched at the start, and dry for nine steps: the pores' first filling is not 0
sed -e 's/^  viscosity.*/&\n  pores: {permeability: 1.0e-13, biot: 0.7, modulus: 2.0e10}/' \
  -e 's/^  cracks:.*/&\n  initial: [{shape: sine, along: x, centre: 0.02, width: 0.08, displacement: [4.0e-7, 0]}]/' \
  -e 's/^stages: \[{name: pump, steps: 40/stages: [{name: dry, steps: 9, integrator: verlet}, {name: pump, steps: 31/' \
  short.yaml >porous.yaml
sed -e 's/^  viscosity.*/&\n  leak_off: 1.0e-6/' short.yaml >leaky.yaml
# resumed KIND CHECKPOINT STEP: the run of the kind goes on from its checkpoint after this step to the same series
resumed() {
  code 0 ranks 1 run "$1.yaml" --out "$1_$3" --resume="$1/checkpoint/$2.h5"
  sed -n '1,2p' "$1/series.csv" >tail.csv
  awk -F, -v from="$3" 'NR > 2 && $1 > from' "$1/series.csv" >>tail.csv
  same tail.csv "$1_$3/series.csv"
  volumes_balance "$1_$3/series.csv"
}
for kind in plate block porous leaky open; do
  code 0 ranks 2 run $kind.yaml --out $kind
  volumes_balance $kind/series.csv
  if thorough || [ $kind = plate ] || [ $kind = open ]; then # the others go on from the middle on one rank
    code 0 ranks "$(by_day 1 3)" run $kind.yaml --out ${kind}_3
    same $kind/series.csv ${kind}_3/series.csv
  fi
  middle=$(awk -v kind=$kind 'BEGIN { print kind == "plate" ? 50 : kind == "block" ? 25 : 20 }')
  # by day the block, which has the plate's state in space, does not go on
  if thorough || [ $kind != block ]; then resumed $kind "step_000000$middle" "$middle"; fi
done
resumed porous stage_dry 9
code 0 ranks 1 check plate.yaml
grep -q 'crack fluid  in 96 particles' out || fail "check does not say the wet particles"
grep -q 'injection  of 2e-05 m3/s by 12 of them' out || fail "check does not say the injection"
# said SENTENCE...: check says each of these
said() { for s; do grep -qF -- "$s" out || { cat out >&2; fail "not said: $s"; }; done; }
said "regime     K'/(mu' E'^3 Q0)^(1/4) = 0.474: viscosity" 'from a half length of 0.006 m, 6 spacings' \
  'tip runs at 0.0902 sqrt(E/rho_s) at first' 'net pressure of 3.83e+07 Pa, above E s0 = 2.09e+07 Pa' \
  'shortest lag that this spacing can have is up to 0.055 m, 55 spacings, with least_pressure: -2.09e+07'
# and the log of a run gives the same warnings
sed -n 's/^  warning: \(crack_fluid.*\)/\1/p' out >want
sed -n 's/^warning: \(crack_fluid.*\)/\1/p' plate/run.log >got
cmp -s want got && [ "$(wc -l <got)" = 3 ] || { cat want got; fail "check and the log differ on an injection"; }
# slow and confined, with a load as large as a field stress
sed -e 's/viscosity: 1.0e-3/&\n  least_pressure: -5.0e6/; s/rate: 2.0e-5/rate: 1.0e-6/' \
  -e 's/0, 1.0e3\]/0, 4.0e9]/' plate.yaml >confined.yaml
code 0 ranks 1 check confined.yaml
said 'stands for a confining stress of 5e+06 Pa' 'raise the fracture energy to 1.32 G0' \
  'loads reach 4e+06 Pa. Where they compress the crack its fracture energy is 1.25 G0' \
  "fluid's front is up to 0.424 m, 424 spacings, behind the tip" 'the lag is longer than the notch'
! grep -qE 'inertia counts|break everywhere' out || fail "warned of a slow crack"
# a notch through a row of particles, and a pressure above the strength
sed 's/rate: 2.0e-5/pressure: 3.0e7/; s/0.02\], \[0.026, 0.02\]/0.0195], [0.026, 0.0195]/' plate.yaml >row.yaml
code 0 ranks 1 check row.yaml
said 'the cracks of the scene leave 12 particles without a bond' 'a pressure of 3e+07 Pa is above E s0 = 2.09e+07 Pa'
! grep -qE 'regime|lag' out || fail "a regime of a given pressure"
grep -q 'warning: crack fluid: the tips run at .* inertia counts' plate/run.log || fail "the run does not say the speed"
code 0 ranks 1 check porous.yaml
grep -q 'pores      in all 1600 particles; pressure spreads by' out || fail "check does not say the pores"
# the mouths take the pressure of the flow beside the wall, the flow gives what they take, and bonds break
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  END { p = $at["mouth_pressure"]; given = $at["handed_volume"]/$at["mouth_volume"]
    exit !(p > 60 && p < 140 && given > 0.9 && given < 1.1 && $at["mouths"] >= 48 && $at["div_max"] < 1e-10 &&
      $at["momentum_residual"] < 1e-10 && $at["e_fracture"] > 0) }' open/series.csv || fail "open: the mouths"
# the load by reaction leaves out the pressure inside the body, and so do the faces of its cracks
last() { awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) k = i } END { print $k }' "$1"; }
code 0 ranks 1 run dry_slot.yaml --out dry_slot
code 0 ranks "$(by_day 1 2)" run slot.yaml --out slot
code 0 ranks "$(by_day 2 1)" run slot.yaml --out slot_240 --resume=slot/checkpoint/step_00000240.h5
for what in crack_volume aperture_max; do
  # whole series do not agree: loads and momentum are round-off here
  awk -v a="$(last slot/series.csv $what)" -v b="$(last slot_240/series.csv $what)" 'BEGIN {
    d = a / b - 1; exit !(d < 1e-10 && d > -1e-10) }' || fail "slot resumed on another number of ranks: $what"
  awk -v wet="$(last slot/series.csv $what)" -v dry="$(last dry_slot/series.csv $what)" 'BEGIN {
    d = wet / dry - 1; exit !(dry > 0 && d < 0.02 && d > -0.02) }' || fail "slot under pressure: $what"
done
code 0 ranks 1 check open.yaml
grep -q 'mouths     at 48 of' out || fail "check does not say the mouths"
grep -q 'least_pressure: an empty crack holds together with 19 times' out || fail "check does not say the suction"
# a scene without the section has none of its columns
sed -e '/^crack_fluid/,/injections/d; s/, crack_fluid: true//' plate.yaml >dry.yaml
code 0 ranks 1 run dry.yaml --out dry --set stages.pump.steps=10
! grep -qE 'injected_volume|wet_particles' dry/series.csv || fail "columns of a fluid that the scene does not have"
# refused SENTENCE SED: the plate, changed by sed, is refused with the sentence
refused() {
  sed "$2" plate.yaml >bad.yaml
  code 2 ranks 1 check bad.yaml
  grep -qF -- "$1" err || { cat err >&2; fail "not said: $1"; }
}
refused "crack_fluid.injections[0]: no particle with a broken bond stands between low and high" \
  's/low: \[0.019, 0.017\], high: \[0.021, 0.023\]/low: [0.001, 0.001], high: [0.004, 0.004]/'
refused "crack_fluid.leak_off = 1.0e-6: not together with pores" \
  's/^  viscosity.*/&\n  leak_off: 1.0e-6\n  pores: {permeability: 1.0e-13, biot: 0.7}/'
refused "crack_fluid.pores.biot = 1.2: must be" 's/^  viscosity.*/&\n  pores: {permeability: 1.0e-13, biot: 1.2}/'
refused "stages[0].crack_fluid = true: needs integrator: verlet" 's/integrator: verlet/integrator: rk3/'
refused "stages[0].crack_fluid = true: cannot go with relax" 's/steps: 80/steps: 80, relax: true/'
refused "stages[0].crack_fluid = true: needs the section crack_fluid" '/^crack_fluid/,/injections/d'
refused "crack_fluid: flows in no stage" 's/, crack_fluid: true//'
refused "crack_fluid: needs particles on the lattice" \
  's/shape: rectangle/arrangement: {kind: perturbed, perturbation: 0.1}, &/'
refused "crack_fluid: cannot go with solid.refinement" 's/^solid:/&\n  refinement: {levels: 1}/'
refused "crack_fluid.viscosity = 0: must be greater than 0" 's/viscosity: 1.0e-3/viscosity: 0/'
refused "crack_fluid.injections[0].time[1] = [0, 1]: must be later" 's/5.0e-5, 1/0, 1/'
cp open.yaml plate.yaml
refused "crack_fluid.least_pressure: missing; a scene with a fluid needs it" 's/least_pressure: -1.0e3, //'
refused "crack_fluid.viscosity = 1.0e-3: must be that of the section fluid" 's/crack_fluid: {/&viscosity: 1.0e-3, /'
refused "stages[0].crack_fluid = true: needs solid: elastic" 's/integrator: verlet/solid: rigid, &/'
refused "cannot go with the section fluid" 's/crack_fluid: {/&pores: {permeability: 1.0e-13, biot: 0.7}, /'
echo ok
