#!/usr/bin/env bash
# What the text and the table of docs/tutorials/injection.md say, to the difference that another compiler makes to a
# crack's slips.
fail() {
  echo "injection.md: $1"
  exit 1
}
grep -q 'toughness (viscosity dominates below 1' ../all || fail "the thin fluid is not in the toughness regime"
grep -q 'warning: crack_fluid: without a confining stress' ../all || fail "no warning of the thick fluid"
for file in notch/post/report.html notch/post/plots/injection.png notch/post/pictures/aperture.png \
  notch/post/pictures/crack_pressure.png notch/post/film/aperture.png viscous/post/pictures/crack_pressure.png \
  compared/plots/crack_pressure.png compared/plots/crack_aperture.png compared/plots/crack_wet.png; do
  [ -s $file ] || fail "no $file"
done
# within NAME LOW HIGH [RUN]: a row of summary.csv
within() {
  awk -F, -v name="$1" -v low="$2" -v high="$3" '$1 == name { v = $3 }
    END { exit !(v >= low && v <= high) }' "${4:-notch}/post/summary.csv" || fail "$1 is not in $2 to $3"
}
within 'pressure as the first bond broke' 4.1e6 5.2e6
within 'breakdown pressure' 4.6e6 6.2e6
within 'closure pressure' 0 1e6
within 'error of the volumes over the injected one' 0 1e-12
within 'breakdown pressure' 6.0e6 7.2e6 viscous
