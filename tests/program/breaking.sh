#!/usr/bin/env bash
# fragments.csv and reactions.csv: the same on any number of ranks; continued by a resumed run and across a refinement.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# shellcheck source=tests/program/scenes.sh
. "$source/tests/program/scenes.sh"
{
  notched_bar -0.05 0.1
  cat <<'EOS'
  loads:
    - {low: [0.013, 0, 0], high: [0.015, 0.02, 0.02], force: [0, 1000, 0], time: [[0, 0], [1.0e-3, 1]]}
stages:
  - {name: pull, steps: 190, integrator: verlet, time_step: 8.0e-6, substeps: 1, breakage: false}
  - {name: break, steps: 130, time_step: 8.0e-6, substeps: 2}
output: {series_every: 10, fields_every: auto, checkpoint_every: 43}
EOS
} >scene.yaml
# cell FILE COLUMN CONDITION...: the column in the rows that meet an awk condition on the columns, by name
cell() {
  awk -F, -v wanted="$2" "NR == 1 { for (i = 1; i <= NF; i++) at[\$i] = i }
    NR > 2 && ($3) { printf \"%s%s\", said++ ? \" \" : \"\", \$at[wanted] }" "$1"
}
# Numbers of fragments, ids, particles, times of detachment and masses of each row agree; places to 1e-9 m, velocities
# to 1e-6 m/s: a crumb in flight has felt round-off through contact.
alike() {
  diff <(cut -d, -f1-10 "$1") <(cut -d, -f1-10 "$2") >/dev/null ||
    { same <(cut -d, -f1-10 "$1") <(cut -d, -f1-10 "$2"); }
  paste -d, <(cut -d, -f11- "$1") <(cut -d, -f11- "$2") | awk -F, 'NR > 2 { n = NF / 2
    for (i = 1; i <= n; i++) { d = $i - $(i + n); if (d < 0) d = -d
      if (!(d < (i > 2 && i < 6 || i == 1 ? 1e-9 : 1e-6))) { print NR, $0; exit 1 } } }' || fail "$1 and $2 differ"
}

code 0 ranks 1 run scene.yaml --out whole
rows=$(awk 'NR > 2' whole/fragments.csv | wc -l)
[ "$rows" -gt 40 ] || fail "$rows rows of fragments: the bar has not broken"
holds "$(cell whole/fragments.csv detached '$at["fragment"] == 1 && $1 == 320') > 190 * 8e-6" # before, no bond broke
[ "$(cell whole/fragments.csv from '$at["fragment"] == 1' | cut -d' ' -f1)" = 0 ] || fail "1 does not come off 0"
# 16 steps between two dumps: 20 of them, and the end of the first stage
[ "$(find whole/fields -name 'solid_*.hdf' | wc -l)" = 21 ] || fail "$(find whole/fields -name '*.hdf' | wc -l) dumps"
# every complete list holds the whole mass, 720 particles of 3000 kg/m3
awk -F, 'NR > 2 { if ($3 == 0) { step = $1; lists++ } if ($1 == step) { mass[step] += $9; particles[step] += $7 } }
  END { for (s in mass)
      if ((mass[s] / (720 * 3e-6) - 1) ^ 2 > 1e-28 || particles[s] != 720) { print s, mass[s]; exit 1 }
    exit lists != 22 }' whole/fragments.csv || fail "complete lists of fragments do not hold the whole mass"
# the file and the series count the same pieces at the end
[ "$(cell whole/fragments.csv id '$1 == 320' | wc -w)" = "$(cell whole/series.csv fragments '$1 == 320')" ] ||
  fail "other fragments than in the series"
# the forces: the held end is pulled to the left, the other to the right; the load is 0.5 a time's mean over the step
[ "$(cell whole/reactions.csv particles '$1 == 100')" = "108 108 72" ] || fail "particles of the constraints"
holds "$(cell whole/reactions.csv force_x '$1 == 150 && $3 == 0 && $4 == 0') < 0"
holds "$(cell whole/reactions.csv force_x '$1 == 150 && $3 == 0 && $4 == 1') > 0"
holds "($(cell whole/reactions.csv force_y '$1 == 100 && $3 == 1') / (1000 * 72e-9 * 99.5 * 8e-3) - 1) ^ 2 < 1e-20"
holds "($(cell whole/reactions.csv displacement_x '$1 == 100 && $3 == 0 && $4 == 1') / (0.1 * 8e-4) - 1) ^ 2 < 1e-20"

for n in 2 $(by_day "" 4); do
  code 0 ranks $n run scene.yaml --out ranks$n
  alike whole/fragments.csv ranks$n/fragments.csv
  forces whole/reactions.csv ranks$n/reactions.csv
done

# resumed on other ranks between two samples, while it breaks: later rows go
echo step_00000301.h5 >ranks2/checkpoint/latest
code 0 ranks "$(by_day 1 3)" run scene.yaml --out ranks2 --resume
grep -q '"resumed_at_step": *301' ranks2/run.json || fail "not resumed at step 301"
alike whole/fragments.csv ranks2/fragments.csv
forces whole/reactions.csv ranks2/reactions.csv
# in another folder, the numbers and times go on. It begins with a list, so what came off in the step before it has the
# time of that list there, and that of the next one in the whole run
code 0 ranks 1 run scene.yaml --out branch --resume=whole/checkpoint/step_00000301.h5
early='$1 == 320 && $at["detached"] < 300.5 * 8e-6'
[ "$(cell whole/fragments.csv detached "$early" | wc -w)" -gt 40 ] || fail "too little came off before the resume"
diff <(cell whole/fragments.csv detached "$early") <(cell branch/fragments.csv detached "$early") ||
  fail "times of detachment are lost in another folder"

code 0 ranks 1 run scene.yaml --out none --set output.fragments=false --set output.reactions=false \
  --set stages.pull.steps=1 --set stages.break.steps=1
[ ! -e none/fragments.csv ] && [ ! -e none/reactions.csv ] || fail "files that the scene does not want"

# at rest, a support bears the load
sed -e '/cracks:/,/points/d; /0.027, 0/d; s/velocity: .*/}/; s/directions: xyz, }/directions: xyz}/' \
  -e '/name: break/d; s/{name: pull.*/{name: rest, steps: 1, relax: true, breakage: false}/' scene.yaml >rest.yaml
code 0 ranks 2 run rest.yaml --out rest --set 'solid.loads[0].time=[[0, 1], [1, 1]]'
holds "($(cell rest/reactions.csv force_y '$3 == 0') / -(1000 * 72e-9) - 1) ^ 2 < 1e-10"
holds "$(cell rest/reactions.csv displacement_y '$3 == 1') > 0"

# a plate that is refined while it breaks: numbers go on with its new particles
refined_plate 3 'series_every: 5, fields_every: 0, checkpoint_every: 40' >plate.yaml
code 0 ranks 1 run plate.yaml --out plate
grep -q "particles refined" plate/run.log || fail "nothing is refined: the rest would test nothing"
[ "$(cell plate/fragments.csv id '$1 == 240' | wc -w)" -gt 1 ] || fail "the plate has not broken"
awk -F, 'NR > 2 && $1 == 240 { mass += $9 } END { exit !((mass / (2440 * 15 * 20 * 1e-9) - 1) ^ 2 < 1e-24) }' \
  plate/fragments.csv || fail "fragments of a refined plate do not hold its mass"
code 0 ranks "$(by_day 2 3)" run plate.yaml --out plate3
# all but the ids, which in a refined plate depend on the ranks
numbers() { cut -d, -f1-5,7-8 "$1" | grep -v ^200,; }
diff <(numbers plate/fragments.csv) <(numbers plate3/fragments.csv) || fail "other fragments on other ranks"
echo step_00000200.h5 >plate3/checkpoint/latest
code 0 ranks 1 run plate.yaml --out plate3 --resume
grep -q '"resumed_at_step": *200' plate3/run.json || fail "not resumed at step 200"
diff <(numbers plate/fragments.csv) <(numbers plate3/fragments.csv) || fail "other fragments after resuming"
echo ok
