# shellcheck shell=bash
# Sourced by the cases of plates: runs under $runs, and numbers of their cracks from post/ and crack.csv.
# shellcheck source=cases/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
frana=${FRANA:-build/frana}

# go NAME SCENE [--set ...]: runs it into $runs/NAME and reads its crack, unless that is done
go() {
  local name=$1 scene=$2
  shift 2
  if ! is_done "$runs/$name"; then
    rm -rf "${runs:?}/$name"
    "$frana" run "$scene" --out "$runs/$name" "$@"
  fi
  [ "$runs/$name/post/crack-summary.csv" -nt "$runs/$name/run.json" ] || "$frana" post "$runs/$name"
}

# of NAME QUANTITY: a number of NAME's crack-summary.csv, nothing where it has none
of() {
  awk -v q="$2" '{ gsub(/"/, ""); v = $0; sub(/.*,/, "", v); sub(/,[^,]*,[^,]*$/, ""); if ($0 == q) print v }' \
    "$runs/$1/post/crack-summary.csv"
}

# variation NAME SCENE WORD...: go with the words, in which :_ stands for a colon and a space; what it says goes to
# $runs/NAME.log
variation() {
  local name=$1 scene=$2 words=() w
  shift 2
  for w in "$@"; do words+=("${w//:_/: }"); done
  go "$name" "$scene" "${words[@]}" >"$runs/$name.log"
}

# meet NAME AXIS REACH: x (m) where the branch's way, a straight line by least squares through the left tip's places
# over REACH behind the place from which undamaged particles part the branches, comes from the axis y = AXIS
meet() {
  local from
  from=$(of "$1" "branching, x")
  [ -z "$from" ] || awk -F, -v p="$from" -v axis="$2" -v reach="$3" '
    NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
    NR > 2 { x = $k["left_x"]; y = $k["left_y"] - axis }
    NR > 2 && x >= p && x <= p + reach && !seen[x]++ { n++; sx += x; sy += y; sxx += x * x; sxy += x * y }
    END { b = (n * sxy - sx * sy) / (n * sxx - sx * sx);
      if (b > 0) printf "%.6g\n", (sx - sy / b) / n }' "$runs/$1/crack.csv"
}

# top NAME WINDOW: largest speed (m/s) of the upper tip over windows (s) that stand end to end, as 000's eq. 41 has them
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

# mirrored NAME AXIS SPACING: a row: of the run's particles, how many are not their mirror image's about y = AXIS to the
# bit
mirrored() {
  local state
  state=$("$(dirname "${BASH_SOURCE[0]}")/symmetric.sh" "$runs/$1" "$2" "$3") || true
  row "$1: particles that are no mirror image to the bit" 1 \
    "$(awk '{ print $1 == "symmetric" ? 0 : $1 == "unsymmetric" ? $2 : "" }' <<<"$state")" 0 "symmetry" 0 0
}
