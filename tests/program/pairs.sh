#!/usr/bin/env bash
# All pairs of a scene's choices: the run ends with finite numbers, and a resumed run on another number of ranks gives
# the same results; or the pair is refused in one sentence before any file is written.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
block='{name: block, material: soft, shape: box, low: [0.05, 0.0, 0.02], high: [0.07, 0.055, 0.06]}'
fluid=(
  'title: Pairs'
  'domain: {size: [0.16, 0.08, 0.08], cells: [32, 16, 16]}'
  'fluid:' '  density: 1000' '  viscosity: 1.0e-3' '  initial: {velocity: [0.1, 0, 0]}' '  sides:'
  '    x_low: {type: inflow, profile: uniform, bulk_velocity: 0.1}' '    x_high: {type: outflow}'
  '    y_low: {type: wall}' '    y_high: {type: wall}' '    z_low: {type: periodic}' '    z_high: {type: periodic}'
  'solid:' '  materials: [{name: soft, youngs_modulus: 1.0e6, density: 3000, fracture_energy: .inf}]'
  "  bodies: [$block]"
  '  constraints: [{low: [0, 0, 0], high: [0.16, 0.006, 0.08]}]'
  'coupling: {medium: {low: [0.02, 0, 0], high: [0.14, 0.08, 0.08]}}'
  'stages:' '  - {name: flow, steps: 6, time_step: 1.0e-3, solid: rigid}'
  '  - {name: move, steps: 14, time_step: 1.0e-3, integrator: verlet, damping_relative: 1.0e12}'
  'output: {series_every: 2, checkpoint_every: 12}')
plate=(
  'title: Pairs' 'domain: {size: [0.06, 0.04]}' 'solid:' '  spacing: 0.001' '  model: plane_stress' '  thickness: 0.002'
  '  materials: [{name: glass, youngs_modulus: 7.2e10, density: 2235, fracture_energy: .inf}]'
  '  bodies: [{name: block, material: glass, shape: rectangle, low: [0, 0], high: [0.06, 0.04]}]'
  '  cracks: [{points: [[0, 0.02], [0.02, 0.02]]}]' '  loads:'
  '    - {edge: {from: [0, 0.04], to: [0.03, 0.04]}, traction: [0, 8.0e6]}'
  'stages:' '  - {name: flow, steps: 100, time_step: 5.0e-8, breakage: false}'
  '  - {name: move, steps: 100, time_step: 5.0e-8}'
  'output: {series_every: 20, checkpoint_every: 120}')
ball='{name: ball, material: soft, shape: sphere, centre: [0.11, 0.04, 0.04], radius: 0.0149}'
setting() { # CHOICE BASE: its settings, one a line
  case $1.$2 in
    implicit.*) echo fluid.diffusion=implicit ;;
    multistep.*) echo stages.move.fluid_integrator=ab2 ;;
    shape.*) echo coupling.surface=shape ;;
    auto.*) printf '%s\n' stages.flow.time_step=auto stages.move.time_step=auto ;;
    breakage.fluid) echo solid.materials.soft.fracture_energy=5.0e-4 ;;
    breakage.plate) echo solid.materials.glass.fracture_energy=20 ;;
    several.fluid) echo "solid.bodies=[$block, $ball]" ;;
    several.plate) printf 'solid.bodies=[%s, %s]\n' '{shape: rectangle, low: [0, 0], high: [0.04, 0.04]}' \
      '{shape: rectangle, low: [0.041, 0], high: [0.06, 0.04]}' ;;
  esac | sed 'i--set'
}
# A plate with a fluid is refused for several reasons, each of which is reported.
refused() { # NAME SENTENCE
  [ "$(grep -c '^frana: ' err)" = 1 ] || [ $1 = implicit-plate ] || { cat err >&2; fail "$1: not one sentence"; }
  grep -q "$2" err || { cat err >&2; fail "$1: not what was to be said"; }
  [ ! -e "$1" ] || fail "$1: refused after its folder was made"
}
# cell FOLDER COLUMN: in the last row of its series
cell() {
  awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) k = i } END { print $k }' "$1/series.csv"
}
# The refused pairs, by both names in the order below
says() {
  case $1 in
    implicit-multistep) echo 'fluid_integrator = ab2: does not go with fluid.diffusion: implicit' ;;
    multistep-plate) echo 'fluid_integrator' ;;
    implicit-breakage) echo 'needs a solid that does not break' ;;
    implicit-plate) echo 'a plate, of 2, has no fluid yet' ;;
    shape-plate) echo 'coupling' ;;
  esac
}
choices=(implicit multistep shape auto breakage several plate)
count=0
for ((i = 0; i < ${#choices[@]}; i++)); do
  for ((k = i + 1; k < ${#choices[@]}; k++)); do
    one=${choices[i]} two=${choices[k]} name=${choices[i]}-${choices[k]} base=fluid
    [ $two = plate ] && base=plate && printf '%s\n' "${plate[@]}" >scene.yaml || printf '%s\n' "${fluid[@]}" >scene.yaml
    mapfile -t with < <(setting $one $base; setting $two $base)
    said=$(says $name)
    if [ -n "$said" ]; then
      code 2 "$frana" run scene.yaml --out $name "${with[@]}"
      refused $name "$said"
      continue
    fi
    n=$((count++ % 3 + 1))
    code 0 ranks $n run scene.yaml --out $name "${with[@]}"
    grep -q '"status": *"done"' $name/run.json || fail "$name is not done"
    # the couple's balance is not computed with implicit diffusion and with ab2
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) asked[i] = $i != "angular_momentum_residual" }
      NR > 2 { for (i = 1; i <= NF; i++) bad += asked[i] && $i ~ /nan|inf/ }
      END { exit bad > 0 }' $name/series.csv || fail "$name: no numbers"
    code 0 ranks $((n % 3 + 1)) run scene.yaml --out $name-again \
      --resume="$(ls $name/checkpoint/step_*.h5 | head -n 1)" "${with[@]}"
    awk -F, 'NR == FNR { if (FNR > 2) first = first ? first : $1; next } FNR <= 2 || $1 >= first' \
      $name-again/series.csv $name/series.csv >tail.csv
    same tail.csv $name-again/series.csv
    case $name in *breakage*) [ "$(cell $name bonds_broken)" -gt 0 ] || fail "$name: nothing has broken" ;; esac
  done
done
# An elastic body under implicit diffusion: the initial motion decays, and its load is that of explicit diffusion.
printf '%s\n' "${fluid[@]}" >scene.yaml
long=(--set stages.flow.steps=100 --set stages.move.steps=300 --set output.series_every=20
  --set output.checkpoint_every=0)
code 0 ranks 1 run scene.yaml --out explicit "${long[@]}"
code 0 ranks 2 run scene.yaml --out implicit "${long[@]}" --set fluid.diffusion=implicit
mean() {
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "load_x") k = i }
    NR > 2 && $1 > 200 { sum += $k; n++ }
    END { print sum / n }' $1/series.csv
}
awk -v a="$(mean explicit)" -v b="$(mean implicit)" 'BEGIN {
    d = b / a - 1; print "load, implicit over explicit:", 1 + d
    exit !(d < 0.01 && d > -0.01) }' ||
  fail "the load of an elastic body under implicit diffusion"
for run in explicit implicit; do
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) { if ($i == "e_kinetic_solid") k = i; if ($i == "e_strain") s = i } }
    NR > 2 { e = $k + $s; if ($1 > 100 && $1 <= 200 && e > early) early = e; if ($1 > 300 && e > late) late = e }
    END { exit !(late < early) }' $run/series.csv || fail "$run: the body gains energy"
done
# A wall that a stream bends, with seven times the longest explicit step: the place of its top
cat >bend.yaml <<'E1'
title: An elastic wall pushed by a stream
domain: {size: [0.024, 0.016, 0.008], cells: [24, 16, 8]}
fluid:
  density: 1000
  viscosity: 1.0e-3
  driving: {type: pressure_gradient, direction: x, value: 500}
  sides:
    x_low: {type: periodic}
    x_high: {type: periodic}
    y_low: {type: wall}
    y_high: {type: wall}
    z_low: {type: periodic}
    z_high: {type: periodic}
solid:
  materials: [{name: rubber, youngs_modulus: 2.0e4, density: 3000}]
  bodies: [{shape: box, low: [0.009, 0, 0], high: [0.014, 0.010, 0.008]}]
  constraints: [{low: [0.009, 0, 0], high: [0.014, 0.002, 0.008]}]
stages: [{name: bend, steps: 400, time_step: 1.0e-4, integrator: verlet}]
output: {series_every: 10, checkpoint_every: 0, fields_every: 0, probes: {at: [[0.0115, 0.0095, 0.0045]], every: 10}}
E1
code 0 ranks 1 run bend.yaml --out bend_explicit
code 0 ranks 2 run bend.yaml --out bend_implicit --set fluid.diffusion=implicit --set stages.bend.steps=40 \
  --set stages.bend.time_step=1.0e-3
top() { awk -F, 'END { print $7 }' "$1/probes.csv"; }
awk -v a="$(top bend_explicit)" -v b="$(top bend_implicit)" 'BEGIN {
    d = b / a - 1; print "bending, implicit over explicit:", 1 + d
    exit !(a > 1e-4 && d < 0.01 && d > -0.01) }' || fail "a wall that bends under implicit diffusion"
[ $count = 16 ] || fail "$count pairs have run"
echo ok
