#!/usr/bin/env bash
# events.csv: its sums are those of the series, the same on any number of ranks, continued by a resumed run; it
# changes nothing else.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# shellcheck source=tests/program/scenes.sh
. "$source/tests/program/scenes.sh"
{
  notched_bar -0.005 0.01
  cat <<'EOS'
stages:
  - {name: pull, steps: 20, integrator: verlet, time_step: 8.0e-6, substeps: 1, breakage: false}
  - {name: break, steps: 100, time_step: 8.0e-6, substeps: 2}
output: {series_every: 10, fields_every: 0, checkpoint_every: 63, events: true}
EOS
} >scene.yaml
# sums_of RUN: the sums of the events over what the series has at the end: bonds, area, energy
sums_of() {
  awk -F, 'FNR == 1 { for (i = 1; i <= NF; i++) at[FILENAME == ARGV[1] ? "e" : "s", $i] = i; next }
    FNR == 2 { next }
    FILENAME == ARGV[1] { bonds += $at["e", "bonds"]; area += $at["e", "area"]; energy += $at["e", "energy"]
      if ($at["e", "event"] != events++ || $1 + 0 < last) { print "row", FNR > "/dev/stderr"; exit 1 }
      last = $1; next }
    FNR == 3 { cut = $at["s", "bonds_broken"] }
    { broken = $at["s", "bonds_broken"] - cut; crack = $at["s", "crack_area"]; fracture = $at["s", "e_fracture"] }
    END { printf "%d %.14g %.14g %.14g\n", events, bonds / broken, area / crack, energy / fracture }' \
    "$1/events.csv" "$1/series.csv"
}
is_one() {
  for v in "$@"; do
    awk "BEGIN { exit !(($v - 1) ^ 2 < 1e-24) }" || fail "sums of events: $v of what the series has"
  done
}
# Steps, numbers and bonds agree; places, normals, areas and energies to 1e-9 of the largest in the column. A normal is
# compared where its direction stands out.
alike() {
  diff <(cut -d, -f1-4 "$1") <(cut -d, -f1-4 "$2") >/dev/null || fail "$1 and $2 have other events"
  paste -d, "$1" "$2" | awk -F, 'NR == 1 { for (i = 1; i <= NF / 2; i++) at[$i] = i
      normal = at["normal_x"]; sure = at["alignment"] }
    NR > 2 { n = NF / 2
    for (i = 5; i <= n; i++) { if (i >= normal && i < sure && $sure < 0.6) continue
      d = $i - $(i + n); if (d < 0) d = -d; v = $i < 0 ? -$i : $i
      if (v > big[i]) big[i] = v
      if (d > off[i]) off[i] = d } }
    END { for (i in off) if (!(off[i] <= 1e-9 * big[i])) { print "column", i, off[i], big[i] > "/dev/stderr"; exit 1 }
      exit NR < 15 }' || fail "$1 and $2 differ"
}

code 0 ranks 1 run scene.yaml --out whole
read -r events bonds area energy < <(sums_of whole)
[ "$events" -gt 20 ] || fail "$events events: the bar has not broken"
is_one "$bonds" "$area" "$energy"
# the bar is pulled along x: over all events the normals weighted with the area point there
awk -F, 'NR > 2 { along += $8 * $8 * $12; all += $12 } END { exit !(along > 0.6 * all) }' whole/events.csv ||
  fail "normals do not point along the pull"
code 0 ranks "$(by_day 2 4)" run scene.yaml --out four
alike whole/events.csv four/events.csv

# resumed on other ranks between two samples, while it breaks: later rows go
echo step_00000063.h5 >four/checkpoint/latest
code 0 ranks "$(by_day 1 3)" run scene.yaml --out four --resume
grep -q '"resumed_at_step": *63' four/run.json || fail "not resumed at step 63"
alike whole/events.csv four/events.csv
awk -F, 'NR > 2 && $1 > 60 && $1 <= 63' whole/events.csv | grep -q . || fail "no event between sample and checkpoint"

# asking for it changes no bit of the run, and without it there is no file
code 0 ranks 1 run scene.yaml --out none --set output.events=false
[ ! -e none/events.csv ] || fail "a file that the scene does not want"
cmp none/series.csv whole/series.csv || fail "events change the run"
code 2 ranks 1 run scene.yaml --out refused --set stages.break.breakage=false
grep -q "output.events = true: no bond can break: a material with a fracture energy is needed" err || fail "$(cat err)"

# bonds that soften: their whole energy comes when they are torn; the sum of areas is complete at once
soft=("--set" "solid.materials[0].breakage={law: bilinear, tensile_strength: 14000}" "--set" stages.break.steps=110)
code 0 ranks 1 run scene.yaml --out soft "${soft[@]}"
read -r events bonds area energy < <(sums_of soft)
[ "$events" -gt 20 ] || fail "$events events with bonds that soften"
is_one "$bonds" "$area"
awk "BEGIN { exit !($energy > 0.2 && $energy < 1 - 1e-6) }" || fail "$energy of the energy, with bonds that soften"
code 0 ranks "$(by_day 1 3)" run scene.yaml --out soft3 "${soft[@]}" --set stages.break.steps=100
code 0 ranks 2 run scene.yaml --out soft3 --resume "${soft[@]}"
alike soft/events.csv soft3/events.csv

# a plate that is refined while it breaks
refined_plate 0.3 'series_every: 60, fields_every: 0, checkpoint_every: 0, events: true' >plate.yaml
code 0 ranks 1 run plate.yaml --out plate
grep -q "particles refined" plate/run.log || fail "nothing is refined: the rest would test nothing"
read -r events bonds area energy < <(sums_of plate)
[ "$events" -gt 15 ] || fail "$events events of the plate"
is_one "$area" "$energy"
code 0 ranks "$(by_day 2 3)" run plate.yaml --out plate3
alike plate/events.csv plate3/events.csv

# What frana check says of the most rows is reached where each bond is an event of its own: pairs of particles that are
# far from each other. A row takes fewer bytes than the longest numbers would.
pairs=20
{
  cat <<'EOS'
title: Pairs that break one by one
domain: {size: [0.24, 0.01, 0.01]}
solid:
  spacing: 1.0e-3
  materials: [{name: ceramic, youngs_modulus: 1.0e8, density: 3000, fracture_energy: 1.0e-9}]
  bodies:
EOS
  awk -v pairs=$pairs 'BEGIN { for (i = 0; i < pairs; i++)
    printf "    - {name: pair%d, material: ceramic, shape: box, low: [%g, 0.004, 0.004], high: [%g, 0.005, 0.005]}\n",
      i, 0.004 + 0.012 * i, 0.006 + 0.012 * i }'
  cat <<'EOS'
  initial: [{shape: sine, along: x, centre: 0, width: 0.96, displacement: [0.02, 0, 0]}]
stages: [{name: break, steps: 4, integrator: verlet, time_step: 1.0e-6}]
output: {series_every: 1, fields_every: 0, checkpoint_every: 0, events: true}
EOS
} >pairs.yaml
code 0 ranks 1 check pairs.yaml
grep -q "particles 0.001 m apart, $pairs bonds" out || fail "the pairs are not $pairs bonds"
most=$(sed -n 's/.* and \([0-9.]*\) kB of events.csv.*/\1/p' out)
code 0 ranks 1 run pairs.yaml --out pairs
[ "$(tail -n +3 pairs/events.csv | wc -l)" = $pairs ] || fail "the pairs are not $pairs events"
awk -v bytes="$(wc -c <pairs/events.csv)" -v most="$most" '
  BEGIN { exit !(most > 0 && bytes <= 1e3 * most && bytes > 200 * most) }' ||
  fail "events.csv has $(wc -c <pairs/events.csv) bytes, frana check says at most ${most:-nothing} kB"
echo ok
