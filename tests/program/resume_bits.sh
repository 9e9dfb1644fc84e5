#!/usr/bin/env bash
# A run resumed from a checkpoint is the uninterrupted one to the bit, on 1 and on 2 ranks, by day on one of them: its
# series, its fields and its last checkpoint. Bonds are stretched beyond 0.1 %, where their forces need square roots,
# and break.
# usage: resume_bits.sh FRANA SOURCE WORK SAME_VALUES
same_values=$(realpath "$4")
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# shellcheck source=tests/program/scenes.sh
. "$source/tests/program/scenes.sh"
# What differs from another scene by its forces alone is by day on one rank.
two=$(by_day 2 "1 2") one=$(by_day 1 "1 2")
# on=RANKS same_bits SCENE LAST CHECKPOINT...: runs the scene up to step LAST, resumes it from each checkpoint, compares
same_bits() {
  local name=$1 last=$2 n from file
  shift 2
  last=$(printf %08d "$last")
  for n in $on; do
    code 0 ranks $n run "$name.yaml" --out "$name-$n"
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
      NR == 3 { first = $at["bonds_broken"] } END { exit !($at["bonds_broken"] > first) }' "$name-$n/series.csv" ||
      [ "$name" = pressed ] || fail "$name: nothing breaks"
    for from in "$@"; do
      code 0 ranks $n run "$name.yaml" --out again --resume="$name-$n/checkpoint/$from.h5"
      awk -F, -v s="$(sed -n 's/.*"resumed_at_step": *\([0-9]*\).*/\1/p' again/run.json)" '
        FNR <= 2 { next }
        FNR == NR { row[$1] = $0; next }
        $1 > s { rows++; if ($0 != row[$1]) { print "step " $1 > "/dev/stderr"; bad = 1 } }
        END { exit bad || rows < 3 }' "$name-$n/series.csv" again/series.csv ||
        fail "$name on $n ranks: other rows after $from"
      for file in fields/solid_"$last".hdf checkpoint/step_"$last".h5; do
        "$same_values" "$name-$n/$file" "again/$file" >values || {
          cat values >&2
          fail "$name on $n ranks: another $file after $from"
        }
      done
      rm -rf again
    done
  done
}

# a block pulled apart by some 2 %, in double and in mixed precision, at night also without damping; the ends of the
# stages where damping begins and ends, and of one after which the integrator keeps the last sweep
kinds=("double 1.0e12" "mixed 1.0e12")
! thorough || kinds+=("double 0")
for kind in "${kinds[@]}"; do
  read -r precision damping <<<"$kind"
  cat >block-$precision-$damping.yaml <<E2
title: A block pulled apart
domain: {size: [0.016, 0.008, 0.006]}
solid:
  spacing: 0.001
  precision: $precision
  materials: [{name: rubber, youngs_modulus: 1.0e7, density: 1000, fracture_energy: 20}]
  bodies: [{name: block, shape: box, low: [0, 0, 0], high: [0.016, 0.008, 0.006]}]
  constraints:
    - {low: [0, 0, 0], high: [0.002, 1, 1]}
    - {low: [0.014, 0, 0], high: [0.016, 1, 1], velocity: [10, 0, 0]}
stages:
  - {name: pull, steps: 40, integrator: rk3, time_step: 2.0e-6}
  - {name: tear, steps: 60, integrator: verlet, damping_relative: $damping, time_step: 2.0e-6}
  - {name: rest, steps: 50, integrator: verlet}
output: {series_every: 5, checkpoint_every: 75, fields_every: 150}
E2
  from=(step_00000075 stage_tear)
  [ "$damping" = 0 ] || from+=(stage_pull)
  on=$two
  [ "$precision" = double ] || on=$one
  same_bits block-$precision-$damping 150 "${from[@]}"
done

# the same with a Poisson's ratio that takes two passes over the bonds; some break in the first substep after the
# checkpoint
sed 's/fracture_energy: 20/&, poisson_ratio: 0.35/
  s/pull, steps: 40, integrator: rk3/pull, steps: 12, integrator: verlet/
  s/steps: 60, \(.*\), damping_relative: 1.0e12/steps: 28, \1/; /name: rest/d
  s/fields_every: 150/fields_every: 40/' block-double-1.0e12.yaml >block-ratio.yaml
on=$one same_bits block-ratio 40 stage_pull

# a block that breaks at two walls of its fluid, which push it at both checkpoints; its markers have left their cells
# since they were sorted
cat >walls.yaml <<'E3'
title: A brittle block thrown against two walls
domain: {size: [12, 12, 8], cells: [12, 12, 8]}
fluid:
  density: 1
  viscosity: 0.1
  sides: {x_low: {type: wall}, x_high: {type: wall}, y_low: {type: slip}, y_high: {type: wall}, z_low: {type: periodic},
    z_high: {type: periodic}}
solid:
  materials: [{name: stuff, youngs_modulus: 1.0e5, density: 1000, fracture_energy: 200}]
  bodies: [{name: body, shape: box, low: [0.6, 0.7, 2], high: [5.6, 5.7, 6], velocity: [-2, -1.6, 0]}]
stages:
  - {name: rk, steps: 30, time_step: 0.02, integrator: rk3}
  - {name: verlet, steps: 50, time_step: 0.02, integrator: verlet}
output: {series_every: 5, checkpoint_every: 45, fields_every: 80}
E3
on=$one same_bits walls 80 stage_rk step_00000045
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "e_contact") k = i }
  $1 == 30 || $1 == 45 { n += $k > 0 } END { exit n != 2 }' walls-1/series.csv || fail "no wall is met"

# a plate with loads over time and contact, whose particles the lists of bonds hold
torn_plate 0 0.008 'integrator: verlet, damping_relative: 1.0e12' >plate.yaml
on=$one same_bits plate 160 step_00000090

# a porous column under a load and a pressure that grow with time, in the same particles
cases=$source/cases/verification
sed 's/steps: 11250/steps: 20/; s/series_every: 5/series_every: 2/; s/fields_every: .*/fields_every: 20/
  s/checkpoint_every: 0/checkpoint_every: 12/' "$cases/consolidation/terzaghi.yaml" >pressed.yaml
on=$one same_bits pressed 20 step_00000012

# a strip that is hit by another while a fluid is pumped into its crack, resumed in its own folder: no look at all
# stages precedes
cat >pumped.yaml <<'E4'
title: A strip with a pumped crack is hit by another
domain: {size: [0.04, 0.03]}
solid:
  spacing: 0.001
  model: plane_stress
  materials: [{name: m, youngs_modulus: 1.0e9, density: 2000, fracture_energy: 10}]
  bodies:
    - {shape: rectangle, low: [0.005, 0.01], high: [0.025, 0.02]}
    - {shape: rectangle, low: [0.025, 0.01], high: [0.035, 0.02], velocity: [-1, 0.3]}
  cracks: [{points: [[0.01, 0.015], [0.018, 0.015]]}]
crack_fluid:
  viscosity: 1.0e-3
  injections: [{low: [0.012, 0.013], high: [0.015, 0.017], rate: 1.0e-3, time: [[0, 0], [1.0e-5, 1]]}]
stages: [{name: a, steps: 6}, {name: pump, steps: 30, crack_fluid: true}]
output: {series_every: 1, checkpoint_every: 15, fields_every: 36, crack: {every: 1}}
E4
code 0 ranks 1 run pumped.yaml --out pumped
cp -r pumped again
rm again/checkpoint/stage_pump.h5 again/checkpoint/step_00000036.h5
echo step_00000030.h5 >again/checkpoint/latest
code 0 ranks 1 run pumped.yaml --out again --resume
grep -q 'resumed at step 30' again/run.log || fail "pumped: $(grep resumed again/run.log)"
for file in series bodies crack fragments; do
  cmp pumped/$file.csv again/$file.csv || fail "pumped: other rows of $file.csv when resumed in its folder"
done
rm -rf again

# a strip that tears, whose stretched bonds are followed because some of them cannot break
sed 's/steps: 900/steps: 10/; s/series_every: 10/series_every: 1/
  s/checkpoint_every: 0/checkpoint_every: 6\n  fields_every: 11/' "$cases/fracture_energy/scene.yaml" >strip.yaml
on=$one same_bits strip 11 step_00000006

# a porous block in a flow, stopped in the middle of its fracture
scene | sed 's/substeps: 4/substeps: auto/; s/checkpoint_every: .*/checkpoint_every: 140/' >porous.yaml
from=(step_00000140)
! thorough || from+=(stage_settle)
on=$two same_bits porous 180 "${from[@]}"

# the same with Adams and Bashforth's scheme from the second stage on, whose terms each rank keeps
sed 's/name: \(settle\|fracture\),/& fluid_integrator: ab2,/' porous.yaml >multistep.yaml
[ "$(grep -c ab2 multistep.yaml)" = 2 ] || fail "no stages with ab2"
on=2 same_bits multistep 180 "${from[@]}"
echo ok
