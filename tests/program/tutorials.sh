#!/usr/bin/env bash
# The commands of every tutorial (blocks of ```sh in docs/tutorials) run as they stand, in an empty folder, and leave
# the files that the page names.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
mkdir bin && ln -s "$frana" bin/frana && export PATH="$work/bin:$PATH"
export OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_pmix=isolated OMPI_MCA_orte_create_session_dirs=0
pages=0
for page in "$source"/docs/tutorials/*.md; do
  name=$(basename "$page" .md)
  mkdir "$name"
  cd "$name" || fail "no folder $name"
  awk '/^```sh$/ { on = 1; next } /^```$/ { on = 0 } on' "$page" >../"$name.sh"
  [ "$(grep -c . ../"$name.sh")" -gt 3 ] || fail "$page: no commands"
  bash -euo pipefail ../"$name.sh" >../"$name.out" 2>&1 ||
    { tail -20 ../"$name.out" >&2; fail "$page: a command failed"; }
  cd ..
  pages=$((pages + 1))
done
[ $pages -ge 1 ] || fail "no tutorials"

# injection.md: what its text and table say, to the difference that another compiler makes to a crack's slips
grep -q 'toughness (below 1 viscosity rules' injection.out || fail "the thin fluid is not in the toughness regime"
grep -q 'warning: crack_fluid: without a confining stress' injection.out || fail "no warning of the thick fluid"
for file in notch/post/report.html notch/post/plots/injection.png notch/post/pictures/aperture.png \
  notch/post/pictures/crack_pressure.png notch/post/film/aperture.png viscous/post/pictures/crack_pressure.png \
  compared/plots/crack_pressure.png compared/plots/crack_aperture.png compared/plots/crack_wet.png; do
  [ -s injection/$file ] || fail "no $file"
done
# within NAME LOW HIGH [RUN]: a row of summary.csv
within() {
  awk -F, -v name="$1" -v low="$2" -v high="$3" '$1 == name { v = $3 }
    END { exit !(v >= low && v <= high) }' "injection/${4:-notch}/post/summary.csv" || fail "$1 is not in $2 to $3"
}
within 'pressure as the first bond broke' 4.1e6 5.2e6
within 'breakdown pressure' 4.6e6 6.2e6
within 'closure pressure' 0 1e6
within 'error of the volumes over the injected one' 0 1e-12
within 'breakdown pressure' 6.0e6 7.2e6 viscous
echo "$pages tutorials"
