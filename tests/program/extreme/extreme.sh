# shellcheck shell=bash
# Common to the extreme scenes: each is run and checked, and docs/stability.md must contain its result.
#     go RANKS EXIT-CODE SCENE [--set ...]; checks; row SCENE "what happens"
# RANKS "$few": two at night, one by day, where each script has a scene on two ranks and the rooms' tests have the rest.
# With FRANA_STABILITY=FILE the rows are written to that file instead: this makes the page's table.
# shellcheck source=tests/program/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/../common.sh" "$@"
here=$source/tests/program/extreme
# shellcheck disable=SC2034 # used by the scripts that source this file
solid=$here/solid.yaml plate=$here/plate.yaml fluid=$here/fluid.yaml immersed=$here/immersed.yaml few=$(by_day 1 2)

go() {
  local n=$1 want=$2
  shift 2
  rm -rf run
  if [ "$n" = 1 ]; then
    code "$want" ranks 1 run "$1" --out run "${@:2}"
  else
    code "$want" ranks "$n" run "$1" --out run "${@:2}"
  fi
  ended=$want
}
# The first sentence on stderr, without the path of the scene; for an unstable run only its part that is the same on all
# machines, without the step and without the field that fails first.
sentence() {
  grep -m 1 '^frana: .' err | sed -E -e 's/^frana: //' -e 's#/[^ :]*/##g' -e 's/^--set //' \
    -e 's/^(unstable in) step [0-9]+: (u|v|w|solid velocity) = .*/\1 step N: velocity = .../' \
    -e 's/^(unstable in) step [0-9]+: ([a-z ]*[a-z]) = .*/\1 step N: \2 = .../'
}
row() {
  local seen='done' line
  [ "$ended" = 0 ] || seen="\`$(sentence)\`, exit $ended"
  line="| $1 | $2 | $seen |"
  if [ -n "${FRANA_STABILITY:-}" ]; then
    echo "$line" >>"$FRANA_STABILITY"
  else
    grep -qxF -- "$line" "$source/docs/stability.md" || fail "docs/stability.md, Extreme scenes, lacks: $line"
  fi
}
# of STEP COLUMN [FILE]: the sum over the rows of that step (probes have several); STEP may be `last`
of() {
  awk -F, -v step="$1" -v name="$2" '
    NR == 1 {
      for (i = 1; i <= NF; i++) if ($i == name) k = i
      if (!k) { print "no column " name > "/dev/stderr"; exit 1 } }
    NR > 2 { if ($1 != now) { sum = 0; now = $1 } sum += $k; if ($1 == step) { found = 1; at = sum } }
    END { if (k) printf "%.17g\n", step == "last" ? sum : found ? at : "nan" }' "${3:-run/series.csv}"
}
last() { of last "$@"; }
probe() { awk -F, -v p="$1" 'NR <= 2 || $3 == p' run/probes.csv >one && of "$2" "$3" one; } # INDEX STEP COLUMN
fluid_probe() { awk -F, -v p="$1" 'NR <= 2 || $3 == p' run/fluid_probes.csv >one && last "$2" one; } # INDEX COLUMN
calc() { awk "BEGIN { printf \"%.17g\\n\", $* }"; }
# near NAME WANTED TOLERANCE VALUE
near() {
  awk -v want="$2" -v tol="$3" -v x="$4" 'BEGIN {
    d = x - want; if (d < 0) d = -d
    exit !(x == x + 0 && x !~ /n/ && d <= tol) }' ||
    fail "$1 is $4, not $2 to $3"
}
less() {
  awk -v x="$2" -v most="$3" 'BEGIN { exit !(x !~ /n/ && x + 0 < most + 0) }' || fail "$1 is $2, not less than $3"
}
