#!/usr/bin/env bash
# intensity.csv of a plate with bonds: the same on any number of ranks, continued by a resumed run; K of an edge crack
# and of both tips of one inside; what is refused.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'EOS'
title: An edge crack, pulled in two steps
domain: {size: [1, 1.6]}
solid:
  spacing: 0.05
  model: plane_stress
  materials: [{name: plate, youngs_modulus: 1.0e6, density: 1}]
  bodies: [{shape: rectangle, low: [0, 0], high: [1, 1.6]}]
  cracks: [{points: [[-0.5, 0.8], [0.5, 0.8]]}]
  loads:
    - {edge: {from: [0, 0], to: [1, 0]}, traction: [0, -1], time: [[0, 0], [2, 1]]}
    - {edge: {from: [0, 1.6], to: [1, 1.6]}, traction: [0, 1], time: [[0, 0], [2, 1]]}
stages: [{name: pull, steps: 2, relax: true, increment: 1, breakage: false, tolerance: 1.0e-6}]
output: {series_every: 0, fields_every: 0, checkpoint_every: 1, intensity: {radii: [0.3, 0.45], every: 1}}
EOS
# cell FILE STEP RADIUS TIP COLUMN
cell() {
  awk -F, -v s="$2" -v r="$3" -v t="$4" -v c="$5" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == c) k = i }
    NR > 2 && $1 == s && $7 == r && $4 == t { print $k }' "$1"
}

code 0 ranks 1 run scene.yaml --out one
[ "$(wc -l <one/intensity.csv)" = 6 ] || fail "not two times 2 rows: $(cat one/intensity.csv)"
code 0 ranks "$(by_day 2 3)" run scene.yaml --out three
cut -d, -f1-8,10,11 one/intensity.csv >a
cut -d, -f1-8,10,11 three/intensity.csv >b
same a b
# K grows with the load, J with its square; F = 2.8246 in a long plate at a/W = 0.5, more in this short one
# and with 10 spacings a crack
holds "($(cell one/intensity.csv 1 0.45 1 K_I) / $(cell one/intensity.csv 2 0.45 1 K_I) * 2 - 1) ^ 2 < 1e-6"
holds "($(cell one/intensity.csv 1 0.45 1 J) / $(cell one/intensity.csv 2 0.45 1 J) * 4 - 1) ^ 2 < 1e-6"
for r in 0.3 0.45; do
  for c in K_I K_J; do
    holds "$(cell one/intensity.csv 2 $r 1 $c) / sqrt(atan2(0, -1) * 0.5) > 2.75"
    holds "$(cell one/intensity.csv 2 $r 1 $c) / sqrt(atan2(0, -1) * 0.5) < 3.3"
  done
  holds "($(cell one/intensity.csv 2 $r 1 K_II)) ^ 2 < 1e-10"
done
code 0 ranks 1 run scene.yaml --out stopped --set stages.pull.steps=1
cp stopped/intensity.csv before
code 0 ranks 2 run scene.yaml --out stopped --resume
cut -d, -f1-8,10,11 one/intensity.csv >a
cut -d, -f1-8,10,11 stopped/intensity.csv >b
same a b
cmp <(head -n 4 before) <(head -n 4 stopped/intensity.csv) || fail "rows before the checkpoint have changed"

# a crack inside, slanted: two tips, alike by symmetry; the opposite slant turns the sign of K_II
inside() { echo "solid.cracks=[{points: [[$1, $2], [$3, $4]]}]"; }
inner=(--set 'output.intensity.radii=[0.3]' --set stages.pull.steps=1)
code 0 ranks 1 run scene.yaml --out inside --set "$(inside 0.35 0.65 0.65 0.95)" "${inner[@]}"
code 0 ranks 1 run scene.yaml --out mirror --set "$(inside 0.35 0.95 0.65 0.65)" "${inner[@]}"
for c in K_I K_II J; do
  holds "($(cell inside/intensity.csv 1 0.3 0 $c) / $(cell inside/intensity.csv 1 0.3 1 $c) - 1) ^ 2 < 1e-6"
done
holds "($(cell inside/intensity.csv 1 0.3 0 K_I) / $(cell mirror/intensity.csv 1 0.3 1 K_I) - 1) ^ 2 < 1e-6"
holds "($(cell inside/intensity.csv 1 0.3 0 K_II) / $(cell mirror/intensity.csv 1 0.3 1 K_II) + 1) ^ 2 < 1e-6"
holds "$(cell inside/intensity.csv 1 0.3 0 K_II) / $(cell inside/intensity.csv 1 0.3 0 K_I) > 0.3"
code 0 ranks 1 run scene.yaml --out last --set "$(inside 0.35 0.65 0.65 0.95)" "${inner[@]}" \
  --set output.intensity.tip=1 --set output.intensity.crack=0
[ "$(wc -l <last/intensity.csv)" = 3 ] || fail "not one tip: $(cat last/intensity.csv)"
[ "$(cell last/intensity.csv 1 0.3 1 x)" = 0.65 ] || fail "not the last point"

# refused WORDS SETTING...
refused() {
  local words=$1 set=() s
  shift
  for s in "$@"; do set+=(--set "$s"); done
  code 2 ranks 1 check scene.yaml "${set[@]}"
  grep -q -- "$words" err || { cat err >&2; fail "not said: $words"; }
}
refused 'radii\[0\] = 0.2: must be at least two horizons, 0.3 m' 'output.intensity.radii=[0.2]'
refused 'radii\[1\] = 0.6: the circle about the tip (0.5, 0.8) leaves the body' 'output.intensity.radii=[0.3, 0.6]'
refused 'radii\[0\] = 0.3: about the tip (0.5, 0.8) it must be at most 0.25 m' \
  'solid.cracks=[{points: [[-0.5, 0.8], [0.25, 0.8], [0.5, 0.8]]}]'
refused 'no end of a crack is inside the body' 'output.intensity.tip=0'
refused 'crack = 1: the scene has 1 cracks, the first is 0' output.intensity.crack=1
sed 's/, intensity: {.*}}/}/' scene.yaml >none.yaml
code 0 ranks 1 run none.yaml --out none --set stages.pull.steps=1
[ ! -e none/intensity.csv ] || fail "intensity.csv of a scene that asks for none"
echo ok
