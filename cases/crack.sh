# Sourced by the cases of plates: runs, numbers of a run's post/, rows of summary.csv.
frana=${FRANA:-build/frana}

# go NAME SCENE [--set ...]: runs it into $runs/NAME and reads its crack, unless that is done
go() {
  local name=$1 scene=$2
  shift 2
  if ! grep -qs '"status": *"done"' "$runs/$name/run.json"; then
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

# json NAME KEY: a number of its run.json
json() { sed -n "s/.*\"$2\": *\([-0-9.e+]*\).*/\1/p" "$runs/$1/run.json" | head -n 1; }

# scaled FACTOR [VALUE]: their product, nothing without a value
scaled() { [ -z "${2-}" ] || awk -v f="$1" -v v="$2" 'BEGIN { printf "%.6g\n", f * v }'; }

# meet NAME AXIS REACH: x (m) where the branch's way, a straight line by least squares through the left tip's places over REACH behind
# the place from which undamaged particles part the branches, comes from the axis y = AXIS
meet() {
  local from
  from=$(of "$1" "branching, x")
  [ -z "$from" ] || awk -F, -v p="$from" -v axis="$2" -v reach="$3" '
    NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
    NR > 2 { x = $k["left_x"]; y = $k["left_y"] - axis }
    NR > 2 && x >= p && x <= p + reach && !seen[x]++ { n++; sx += x; sy += y; sxx += x * x; sxy += x * y }
    END { b = (n * sxy - sx * sy) / (n * sxx - sx * sx); if (b > 0) printf "%.6g\n", (sx - sy / b) / n }' "$runs/$1/crack.csv"
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

# row QUANTITY UNIT OURS REFERENCE SOURCE [LOW HIGH]: a line of $summary; passes between LOW and HIGH
row() {
  awk -v q="$1" -v u="$2" -v x="$3" -v r="$4" -v s="$5" -v a="${6-}" -v b="${7-}" 'BEGIN {
    t = a == "" ? "" : a " to " b
    p = a == "" ? "" : (x != "" && x + 0 >= a + 0 && x + 0 <= b + 0 ? "yes" : "no")
    printf "%s, %s, %s, %s, %s, %s, %s\n", q, u, x, r, s, t, p }' >>"$summary"
}
