# shellcheck shell=bash
# Common to the program's tests. usage: script FRANA SOURCE WORK
set -euo pipefail
frana=$(realpath "$1") source=$(realpath "$2") work=$3
set -a
# shellcheck source=tests/mpi.env
. "$source/tests/mpi.env"
set +a
rm -rf "$work" && mkdir -p "$work" && cd "$work"
exec {nothing}<> <(:) # nothing comes from it: `read -t` waits, without a process such as sleep

# by_day DAY NIGHT: a word that differs by day. ctest's program_NAME_thorough (label nightly) sets FRANA_THOROUGH. More
# ranks than cores spin, and combinations of what others cover take long.
by_day() { if [ -n "${FRANA_THOROUGH:-}" ]; then echo "$2"; else echo "$1"; fi; }
thorough() { [ -n "${FRANA_THOROUGH:-}" ]; }
fail() { echo "FAILED: $*" >&2; exit 1; }
# ranks N ARGUMENTS...: frana on N ranks, one without mpiexec
ranks() {
  local n=$1; shift
  if [ "$n" = 1 ]; then "$frana" "$@"; else mpiexec -n "$n" "$frana" "$@"; fi
}
# ranks_of PID: the processes of the ranks that mpiexec has started: its children, or those of MPICH's proxy
ranks_of() {
  local proxies
  proxies=$(pgrep -d , -P "$1" || true)
  pgrep -P "$1${proxies:+,$proxies}" -x "$(basename "$frana")"
}
# code N command...: the command must end with this exit code; its output goes to out and err
code() {
  local want=$1 got=0; shift
  "$@" >out 2>err || got=$?
  [ "$got" = "$want" ] || { cat out err >&2; fail "exit code $got, not $want: $*"; }
}
# await PID COMMAND...: waits until the command succeeds. Fails if the process ends before. There is no deadline,
# which a busy machine could miss. ctest's own limit ends a test that hangs.
await() {
  local pid=$1; shift
  until "$@"; do
    kill -0 "$pid" 2>/dev/null || { "$@" && return; return 1; }
    read -rt 0.02 -u "$nothing" || true
  done
}
# periodic SIDE...: these sides of a scene's fluid
periodic() { printf '    %s: {type: periodic}\n' "$@"; }
# two_spheres CHECKPOINT_EVERY: prints a scene of two rigid spheres in a periodic flow along [110]
two_spheres() {
  cat <<SCENE
title: Two spheres
domain: {size: [1, 1, 1], cells: [12, 12, 12]}
fluid:
  density: 1
  viscosity: 1
  driving: {type: pressure_gradient, along: [1, 1, 0], value: 1.0e-6}
  sides:
$(periodic {x,y,z}_{low,high})
solid:
  materials: [{name: rigid, youngs_modulus: 1, density: 1, horizon_ratio: 2}]
  bodies:
    - {name: a, shape: sphere, centre: [0.33, 0.41, 0.45], radius: 0.33}
    - {name: b, shape: sphere, centre: [0.72, 0.77, 0.6], radius: 0.2}
coupling: {surface: shape, medium: {low: [0, 0, 0], high: [1, 1, 1]}}
stages:
  - {name: flow, steps: 2000, cfl: 1, solid: rigid}
output: {series_every: 50, checkpoint_every: $1}
SCENE
}
# value RUN QUANTITY: of RUN/permeability.csv
value() { awk -F, -v q="$2" '$1 == q { print $2 }' "$1/permeability.csv"; }
# holds CONDITION: of numbers, as awk understands it
holds() { awk "BEGIN { exit !($1) }" || fail "$1"; }
# close A B TOLERANCE: relative
close() {
  awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; exit !((d < 0 ? -d : d) <= t * (b < 0 ? -b : b)) }' ||
    fail "$1 and $2 differ by more than $3"
}
# A porous block small enough to test on, one cavity's period wide: 32 x 16 x 16 cells, all stages.
scene() {
  sed -e 's/size: .*/size: [0.05, 0.025, 0.025]/' -e 's/cells: .*/cells: [32, 16, 16]/' \
    -e 's/low: .*-0.0046875, 0]/low: [0.0125, -0.0046875, 0]/' \
    -e 's/high: .*0.0546875, 0.05]/high: [0.0375, 0.0296875, 0.025]/' \
    -e 's/{low: .0, -0.01, 0.*/{low: [0, -0.01, 0], high: [0.05, 0, 0.025], directions: xyz}/' \
    -e 's/{low: .0, 0.05, 0.*/{low: [0, 0.025, 0], high: [0.05, 0.035, 0.025], directions: xyz}/' \
    -e 's/medium: .*/medium: {low: [0.0125, 0, 0], high: [0.0375, 0.025, 0.025]}/' \
    -e 's/fracture_energy: [0-9.e-]*/fracture_energy: 2.0e-3/' \
    -e '/name: flow/s/steps: [0-9]*/steps: 60/; /name: settle/s/steps: [0-9]*/steps: 60/' \
    -e '/name: fracture/s/steps: [0-9]*/steps: 60/' \
    -e 's/series_every: .*/series_every: 15/; s/fields_every: .*/fields_every: 60/' \
    -e 's/checkpoint_every: .*/checkpoint_every: 50/' \
    "$source/cases/porous_channel/demo.yaml"
}
# same A B: two series agree, every number to 1e-10 of the largest in its column. Components of forces are compared with
# the largest force, those of the mean velocity with its largest, columns of round-off errors with 1. The solid's
# momentum and its given loads are sums that may cancel: they are compared with at least 0.01 N s and 10 kN. Angular
# momentum, which may cancel as well and is about the domain's centre, is not compared (tests/coupling/interface/
# test_leaving.c has it on several ranks). Contact's energy agrees to 1e-5: it goes with the square of how far particles
# are nearer than r_c, some 1e-5 of their distance.
same() {
  awk -F, -v a="$1" '
    FNR == 1 && FILENAME == a {
      for (i = 1; i <= NF; i++) { name[i] = $i; if ($i == "load_x") x = i; if ($i ~ /^velocity_/) u[i]
        floor[i] = $i ~ /^angular_momentum/ ? 1e30 : $i ~ /^momentum_[xyz]/ ? 0.01 : $i ~ /^given_/ ? 1e4 : 0 }
    }
    FNR <= 2 { next }
    FILENAME == a {
      rows = FNR
      for (i = 1; i <= NF; i++) { v[FNR, i] = $i; s = $i < 0 ? -$i : $i; if (s > big[i]) big[i] = s
        if (i in u && s > fastest) fastest = s }
      next }
    { other = FNR
      for (i = 1; i <= NF; i++) {
        scale = name[i] ~ /^(load|forcing)_/ ? big[x] : name[i] ~ /div_max|_residual$/ ? 1 : big[i]
        if (i in u) scale = fastest
        if (name[i] == "e_contact") scale = 1e5 * big[i]
        if (scale < floor[i]) scale = floor[i]
        d = v[FNR, i] - $i; if (d < 0) d = -d
        if (!(d <= 1e-10 * scale)) { print name[i], "row", FNR, v[FNR, i], $i > "/dev/stderr"; bad = 1 } } }
    END { exit bad || rows != other }' "$1" "$2" || fail "$1 and $2 differ"
}
# forces A B: two files of reactions agree, to 1e-9 of the largest force, N, and of the largest displacement, m.
forces() {
  paste -d, "$1" "$2" | awk -F, 'NR == 1 { n = NF / 2 } NR > 2 {
    for (i = 1; i <= n; i++) {
      kind = i <= 5 ? i : i <= 5 + (n - 5) / 2 ? "force" : "way"
      d = $i - $(i + n); if (d < 0) d = -d; v = $i < 0 ? -$i : $i
      if (v > big[kind]) big[kind] = v
      if (d > off[kind]) off[kind] = d } }
    END { for (k in off) if (!(off[k] <= 1e-9 * big[k])) { print k, off[k], big[k] > "/dev/stderr"; exit 1 }
      exit NR < 10 }' || fail "$1 and $2 differ"
}
