#!/usr/bin/env bash
# Scenes that are solved at once: run, check, post, study; the same on every number of ranks; sentences for what is
# badly posed. Bodies whose particles stand on no lattice.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
scene=$source/tests/scene/scenes/nonlocal.yaml
many=$(by_day 2 3)
value() { awk -F, -v q="$2" '$1 == q { print $3 }' "$1/solution.csv"; }
says() { grep -q "$1" err || fail "not said: $1: $(cat err)"; }

code 0 ranks 1 check "$scene"
grep -q 'unknowns   *[0-9]' out || fail "no unknowns"
grep -q 'memory' out || fail "no memory"
for n in 1 $many; do
  code 0 ranks $n run "$scene" --out run$n --set output.fields_every=1
  [ -f run$n/fields/solution.hdf ] || fail "no fields"
done
for q in points unknowns spacing lloyd_iterations; do # of the points: to the bit
  [ "$(value run1 $q)" = "$(value run$many $q)" ] || fail "$q is $(value run$many $q) on $many ranks"
done
[ "$(grep lloyd_energy run1/run.json)" = "$(grep lloyd_energy run$many/run.json)" ] ||
  fail "other points on $many ranks"
for q in error_l2 error_linf operator_error condition; do
  awk -v a="$(value run1 $q)" -v b="$(value run$many $q)" \
    'BEGIN { d = a - b; exit !(d * d <= 1e-18 * a * a && a != 0) }' ||
    fail "$q is $(value run1 $q) on 1 rank, $(value run$many $q) on $many"
done
awk -v a="$(value run1 error_l2)" 'BEGIN { exit !(a > 0.001 && a < 0.2) }' || fail "error_l2 $(value run1 error_l2)"
code 0 ranks 1 post run$many
grep -q '^error_l2,' run$many/post/summary.csv || fail "no error in the summary"
[ -f run$many/post/plots/solution_map.gp ] || fail "no map"
[ "$(awk '/^EOD/ { exit } n { points++ } /points << EOD/ { n = 1 } END { print points }' \
  run$many/post/pictures/arrangement.gp)" = "$(awk -F, '$1 == "points" { print $3 }' run$many/solution.csv)" ] ||
  fail "not all points in the picture of the arrangement"

# a folder that holds a run; what such a scene has not
code 4 ranks 1 run "$scene" --out run1
code 2 ranks 1 run "$scene" --out run1 --resume
says 'no checkpoint'
code 2 ranks 1 permeability "$scene" --out k
says 'solved at once'
# badly posed
sed 's/arrangement: .*/arrangement: {kind: lattice}/; s/inner_radius: .*/inner_radius: 0.5/
  s/outer_radius: .*/outer_radius: 3/' "$scene" >bad.yaml
code 2 ranks 1 run bad.yaml --out bad --set nonlocal.horizon=0.2 --set nonlocal.spacing=0.3
says 'has no neighbour within the horizon 0.2 m: a larger horizon'
code 2 ranks 1 run bad.yaml --out bad --set nonlocal.horizon=2 --set nonlocal.spacing=2
says 'no point lies within the inner radius'
code 2 ranks 1 run "$scene" --out bad --set nonlocal.spacing=1.0e-6
says 'a larger spacing needs fewer'
[ ! -e bad ] || fail "a refused run has left a folder"

# an ensemble of seeds
cat >study.yaml <<END
scene: $scene
ensemble: {key: nonlocal.arrangement.seed, values: [3, 4, 5]}
set: {nonlocal.condition: false}
quantity: {file: solution.csv, quantity: error_l2, reference: {value: 0}}
methods: [{name: centroidal}]
levels: [{name: m2}]
END
code 0 "$frana" study study.yaml --out .
row=$(grep '^centroidal,m2' study.csv)
for k in 1 2 3; do value runs/study/centroidal/m2/$k error_l2; done |
  awk -v row="$row" '{ s += $1; q += $1 * $1 } END { split(row, c, ","); m = s / 3; d = sqrt((q - 3 * m * m) / 2)
    e = c[6] / m - 1; f = c[22] / d - 1; exit !(e * e < 1e-20 && f * f < 1e-6 && d > 0) }' ||
  fail "mean, deviation: $row"
[ "$(value runs/study/centroidal/m2/1 error_l2)" != "$(value runs/study/centroidal/m2/2 error_l2)" ] ||
  fail "one seed"

# bodies: a plate with a hole and a sphere, ten steps after a pull, on 1 and 3 ranks
plate() {
  cat <<END
domain: {size: $2}
solid:
  spacing: 0.1
  $3
  materials: [{name: a, youngs_modulus: 1.0e9, density: 1000}]
  bodies: [{$4, arrangement: {kind: $1$5}}]
  initial: [{shape: sine, along: x, centre: 0, width: 1, displacement: $6}]
stages: [{name: wave, steps: 10}]
output: {series_every: 10, fields_every: 0, checkpoint_every: 0}
END
}
for kind in hexagonal perturbed $(by_day "" "centroidal random"); do
  more=$([ $kind = perturbed ] && echo ', perturbation: 0.3' || echo ', volume: cell')
  plate $kind '[1, 1]' 'model: plane_stress' \
    'shape: disc, centre: [0.5, 0.5], radius: 0.45, holes: [{shape: disc, centre: [0.5, 0.5], radius: 0.15}]' "$more" \
    '[1.0e-4, 0]' >plate_$kind.yaml
  plate $kind '[1, 1, 1]' '' 'shape: sphere, centre: [0.5, 0.5, 0.5], radius: 0.4' "$more" '[1.0e-4, 0, 0]' \
    >ball_$kind.yaml
  for body in plate ball; do
    for n in 1 $many; do code 0 ranks $n run ${body}_$kind.yaml --out ${body}_${kind}_$n; done
    paste -d' ' <(tail -1 ${body}_${kind}_1/series.csv | tr , '\n') \
      <(tail -1 ${body}_${kind}_$many/series.csv | tr , '\n') |
      awk '{ d = $1 - $2; if (d * d > 1e-18 * $1 * $1 + 1e-22) bad++ } END { exit bad > 0 || NR < 10 }' ||
      fail "$body, $kind: other rows on $many ranks"
  done
done
edge='loads: [{edge: {from: [0, 0], to: [1, 0]}, traction: [0, 1]}]'
sed 's/^  initial:/  '"$edge"'\n  initial:/; s/shape: disc, .*}\], arr/\
shape: rectangle, low: [0, 0], high: [1, 1], arr/' plate_hexagonal.yaml >edge.yaml
code 2 ranks 1 run edge.yaml --out edge
says 'needs depth: horizon, or a body on the lattice'
