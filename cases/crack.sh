#!/usr/bin/env bash
# What the cases of plates share: numbers of their cracks from post/ and crack.csv of the runs in $runs.
#   cases/crack.sh meet|top|unsymmetric RUN ARGUMENT...    prints the number of a run in the current folder
# Sourced by bash also runs in $runs; if that is --summary, nothing runs, and the numbers are those that
# results/measured.csv keeps.
# shellcheck source=cases/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
frana=${FRANA:-build/frana} again='' runs=${runs-.}
if [ "$runs" = --summary ]; then again=yes; else mkdir -p "$runs"; fi

# go NAME SCENE [--set ...]: runs SCENE in $runs/NAME and runs frana post on it, unless that is done already
go() {
  local name=$1 scene=$2
  [ ! "$again" ] || return 0
  shift 2
  if ! is_done "$runs/$name"; then
    rm -rf "${runs:?}/$name"
    "$frana" run "$scene" --out "$runs/$name" "$@"
  fi
  [ "$runs/$name/post/crack-summary.csv" -nt "$runs/$name/run.json" ] || "$frana" post "$runs/$name"
}

# of NAME QUANTITY: a number from the crack-summary.csv of NAME; nothing if the quantity is missing; kept
of() { kept "$1: $2" of_run "$@"; }
of_run() {
  awk -v q="$2" '{ gsub(/"/, ""); v = $0; sub(/.*,/, "", v); sub(/,[^,]*,[^,]*$/, ""); if ($0 == q) print v }' \
    "$runs/$1/post/crack-summary.csv"
}

# variation NAME SCENE WORD...: calls go with the words. In a word, :_ stands for a colon and a space. The output goes
# to $runs/NAME.log.
variation() {
  local name=$1 scene=$2 words=() w
  shift 2
  for w in "$@"; do words+=("${w//:_/: }"); done
  [ "$again" ] || go "$name" "$scene" "${words[@]}" >"$runs/$name.log"
}

# meet NAME AXIS REACH: x (m) at which the branch's path meets the axis y = AXIS. The path is a straight line, fitted by
# least squares to the positions of the left tip, from the x at which undamaged particles first separate the branches
# and over a length of REACH
meet() {
  local from
  from=$(of_run "$1" "branching, x")
  [ -z "$from" ] || awk -F, -v p="$from" -v axis="$2" -v reach="$3" '
    NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
    NR > 2 { x = $k["left_x"]; y = $k["left_y"] - axis }
    NR > 2 && x >= p && x <= p + reach && !seen[x]++ { n++; sx += x; sy += y; sxx += x * x; sxy += x * y }
    END { b = (n * sxy - sx * sy) / (n * sxx - sx * sx);
      if (b > 0) printf "%.6g\n", (sx - sy / b) / n }' "$runs/$1/crack.csv"
}

# top NAME WINDOW: largest speed (m/s) of the upper tip, from consecutive windows of WINDOW seconds (000: eq. 41)
top() {
  awk -F, -v window="$2" '
    NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
    NR < 3 { next }
    { now = int($k["t"] / window + 1e-6) }
    NR == 3 || now > last {
      if (NR > 3) { v = sqrt(($k["left_x"] - x) ^ 2 + ($k["left_y"] - y) ^ 2) / ($k["t"] - t); if (v > most) most = v }
      last = now; x = $k["left_x"]; y = $k["left_y"]; t = $k["t"] }
    END { printf "%.6g\n", most }' "$runs/$1/crack.csv"
}

# mirrored NAME AXIS SPACING: writes a row with unsymmetric: how many particles of the run are not, to the bit, the
# mirror image of another about y = AXIS
mirrored() {
  row "$1: particles that are no mirror image to the bit" 1 "$(kept "$1: no mirror image" unsymmetric "$@")" 0 \
    "symmetry" 0 0
}
unsymmetric() {
  local state
  state=$("$(dirname "${BASH_SOURCE[0]}")/symmetric.sh" "$runs/$1" "$2" "$3") || true
  awk '{ print $1 == "symmetric" ? 0 : $1 == "unsymmetric" ? $2 : "" }' <<<"$state"
}
[ "${BASH_SOURCE[0]}" != "$0" ] || "$@"
