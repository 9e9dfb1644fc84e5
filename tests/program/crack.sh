#!/usr/bin/env bash
# crack.csv: its format; the same on any number of ranks; continued by a resumed run; and the results of frana post.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'EOF'
title: A small notched plate
domain: {size: [0.05, 0.02]}
solid:
  spacing: 1.0e-3
  model: plane_stress
  materials:
    - {name: glass, youngs_modulus: 72.0e9, density: 2440, fracture_energy: 135}
  bodies:
    - {shape: rectangle, low: [0, 0], high: [0.05, 0.02]}
  cracks:
    - points: [[0, 0.01], [0.02, 0.01]]
  unbreakable:
    - {low: [0, 0], high: [0.05, 0.002]}
    - {low: [0, 0.018], high: [0.05, 0.02]}
  loads:
    - {edge: {from: [0, 0.02], to: [0.05, 0.02]}, traction: [0, 22.0e6]}
    - {edge: {from: [0, 0], to: [0.05, 0]}, traction: [0, -22.0e6]}
stages:
  - {name: pull, steps: 400, integrator: verlet, time_step: 5.0e-8, substeps: 1}
output: {series_every: 20, fields_every: 100, checkpoint_every: 210, crack: {every: 4}}
EOF
code 0 ranks 1 run scene.yaml --out whole
[ "$(wc -l <whole/crack.csv)" = 103 ] || fail "not 101 rows in crack.csv"
grown=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "length") l = i }
  END { print ($l > 0.005) }' whole/crack.csv)
[ "$grown" = 1 ] || fail "the crack has not grown: the rest would test nothing"
code 0 ranks "$(by_day 2 3)" run scene.yaml --out ranks
same whole/crack.csv ranks/crack.csv
same whole/crack_particles.csv ranks/crack_particles.csv
# a row for each damaged particle, and no particle twice
sed 1,2d whole/crack_particles.csv | cut -d , -f 3,4 | sort | uniq -d | grep -q . && fail "a particle has two rows"
[ "$(sed 1,2d whole/crack_particles.csv | cut -d , -f 1 | sort -u | wc -l)" -gt 10 ] || fail "particles without times"

# resumed while the crack grows: the tips of the last window come from the file, whose later rows go
echo step_00000210.h5 >ranks/checkpoint/latest
code 0 ranks 1 run scene.yaml --out ranks --resume
grep -q '"resumed_at_step": *210' ranks/run.json || fail "not resumed at step 210"
same whole/crack.csv ranks/crack.csv
same whole/crack_particles.csv ranks/crack_particles.csv

# perturbed particles: the same on any number of ranks, others with another seed. Two of them may be 0.6 spacings apart,
# where contact's radius of 1 does not burst the notch that parts them
sed '/shape: rectangle/s/}$/, arrangement: {kind: perturbed, perturbation: 0.2, seed: 3}}/' scene.yaml >perturbed.yaml
grep -q 'seed: 3' perturbed.yaml || fail "no perturbed scene"
for n in 1 $(by_day "" 4); do
  code 0 ranks $n run perturbed.yaml --out perturbed_$n --set stages.pull.steps=300 --set output.fields_every=0
done
if thorough; then # by day solve.sh has perturbed particles on two ranks
  same perturbed_1/crack.csv perturbed_4/crack.csv
  same perturbed_1/crack_particles.csv perturbed_4/crack_particles.csv
fi
code 0 ranks 1 run perturbed.yaml --out seed_4 --set stages.pull.steps=300 --set output.fields_every=0 \
  --set solid.bodies[0].arrangement.seed=4
cmp -s perturbed_1/crack_particles.csv seed_4/crack_particles.csv && fail "the seed changes nothing"
code 0 ranks 1 check perturbed.yaml
grep -q 'perturbed  the particles of body1 by up to 0.2 spacings in each direction, seed 3' out || \
  fail "check does not say it"
code 0 ranks 1 post perturbed_1

# no crack asked for, no file
sed 's/, crack: {every: 4}//' scene.yaml >none.yaml
code 0 ranks 1 run none.yaml --out none --set stages.pull.steps=4
[ ! -e none/crack.csv ] || fail "crack.csv of a scene that asks for none"

code 0 ranks 1 post whole --film=energy --level 0.3 --magnify 4
grep -q '^level of the damage contour,1,0.3$' whole/post/crack-summary.csv || fail "--level is not kept"
# the crack runs along x and forks into two arms that are mirror images of each other
awk -F, 'NR > 1 { parent[NR] = $2; x[NR] = $6; y[NR] = $7 - 0.01; angle[NR] = $9; speed[NR] = $15 }
  function near(a, b) { return a - b < 1e-6 && b - a < 1e-6 }
  END { exit !(NR == 4 && parent[2] == 0 && near(angle[2], 0) && near(y[2], 0) && speed[2] > 1000 && speed[2] < 3058 &&
    parent[3] == 1 && parent[4] == 1 && near(x[3], x[4]) && near(y[3], -y[4]) && near(angle[3], -angle[4]) &&
    angle[3] ^ 2 > 25) }' whole/post/crack-arms.csv || fail "not a symmetric fork: $(cat whole/post/crack-arms.csv)"
[ "$(head -1 whole/post/crack-tips.csv)" = arm,t,x,y,speed,jumped ] || fail "no way of the tip"
[ -s whole/post/film/energy_0004.png ] || fail "no film"
code 2 ranks 1 post whole --film=colour
code 2 ranks 1 post whole --level 1.5
code 2 ranks 1 run scene.yaml --out other --magnify 3
echo ok
