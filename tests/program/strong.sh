#!/usr/bin/env bash
# The strongly coupled step, while bonds break: every step converges, the box's momentum balance closes, any number of
# ranks gives the same results, and so does a run resumed from a checkpoint.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
scene | sed -e 's/^coupling:/&\n  scheme: strong\n  tolerance: 1.0e-10/' \
  -e '/name: settle/s/steps: [0-9]*/steps: 20/; /name: fracture/s/steps: [0-9]*/steps: 25/' \
  -e '/name: flow/s/steps: [0-9]*/steps: 30/' \
  -e 's/series_every: .*/series_every: 5/; s/fields_every: .*/fields_every: 0/' \
  -e 's/checkpoint_every: .*/checkpoint_every: 20\n  events: true/' >scene.yaml
code 0 ranks 1 run scene.yaml --out whole
number() { sed -n "s/.*\"$1\": *\([0-9.]*\).*/\1/p" whole/run.json | head -n 1; }
[ "$(number steps_not_converged)" = 0 ] || fail "$(number steps_not_converged) steps have not converged"
awk -v m="$(number mean)" -v n="$(number most)" 'BEGIN { exit !(m > 1.5 && m < 10 && n < 50) }' ||
  fail "$(number mean) iterations a step, $(number most) at most"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 { b = $at["bonds_broken"]; if ($at["momentum_residual"] > 1e-9) bad = 1 }
  END { exit bad || !(b > 100) }' whole/series.csv || fail "the momentum does not close, or nothing has broken"

# a bond that breaks in several iterations of a step is one event
awk -F, 'FNR == 1 { for (i = 1; i <= NF; i++) at[FILENAME, $i] = i }
  FNR > 2 && FILENAME ~ /events/ { bonds += $at[FILENAME, "bonds"]; energy += $at[FILENAME, "energy"] }
  FNR > 2 && FILENAME ~ /series/ { broken = $at[FILENAME, "bonds_broken"]; all = $at[FILENAME, "e_fracture"] }
  END { exit !(bonds == broken && (energy / all - 1) ^ 2 < 1e-24) }' whole/events.csv whole/series.csv ||
  fail "the events are not the bonds that broke"

# values that are zero by symmetry are round-off, which the iteration may amplify up to its tolerance (that of same
# here); all others agree to the digits of same
without() { # without SERIES: leaves out its y and z components, which must be small compared with x
  awk -F, 'NR == 1 {
      for (i = 1; i <= NF; i++) { at[$i] = i; zero[i] = $i ~ /^(load|forcing|velocity)_[yz]$/; name[i] = $i } }
    { row = ""
      for (i = 1; i <= NF; i++) {
        x = at[name[i] ~ /^velocity/ ? "velocity_x" : "load_x"]
        if (!zero[i]) row = row (i > 1 ? "," : "") $i
        else if (NR > 2 && $i ^ 2 > 1e-10 * $x ^ 2) { print "row", NR, $i, $x > "/dev/stderr"; exit 1 } }
      print row }' "$1" >"$1.x" || fail "$1: a force across that is not round-off"
}
code 0 ranks 3 run scene.yaml --out ranks3
without whole/series.csv
without ranks3/series.csv
same whole/series.csv.x ranks3/series.csv.x

code 0 ranks 1 run scene.yaml --out branch --resume=whole/checkpoint/step_00000060.h5
sed -n '1,2p' whole/series.csv >tail.csv && awk -F, 'NR > 2 && $1 > 60' whole/series.csv >>tail.csv
without tail.csv
without branch/series.csv
same tail.csv.x branch/series.csv.x
echo ok
