# What the cases of this folder share. usage: CASE/run.sh [FRANA [RUNS [OUT [quick]]]]
# Runs go to RUNS (default runs/verification/CASE), numbers to OUT (default CASE/results); quick leaves out what takes minutes.
# Leaves with 1 where a number misses its tolerance.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[1]}")" && pwd)
frana=$(realpath "${1:-build/frana}") runs=${2:-runs/verification/$(basename "$here")} out=${3:-$here/results} quick=${4:-}
mkdir -p "$runs" "$out"
summary="$out/summary.csv"
[ "$quick" ] && summary="$out/quick.csv"
echo "quantity,unit,ours,reference,source,tolerance,pass" >"$summary"

# study NAME: of this case; its tables and plots are kept beside the summary.
study() {
  "$frana" study "$here/$1.yaml" --out "$runs" >"$runs/$1.log" 2>&1 || { cat "$runs/$1.log" >&2; exit 1; }
  [ "$quick" ] || cp "$runs/$1".csv "$runs/$1".md "$runs/$1"*.png "$out" 2>/dev/null || true
}
# of STUDY COLUMN METHOD LEVEL QUANTITY: a cell of its table.
of() {
  awk -F, -v c="$2" -v m="$3" -v l="$4" -v q="$5" '/^#/ { next }
    !at { for (i = 1; i <= NF; i++) if ($i == c) at = i; next }
    $1 == m && $2 == l && $4 == q { print $at; found = 1 } END { exit !found }' "$runs/$1.csv" ||
    { echo "$1: no $2 of $3, $4, $5" >&2; exit 1; }
}
calc() { awk "BEGIN { pi = atan2(0, -1); printf \"%.12g\\n\", $1 }"; }

row() { # row QUANTITY UNIT OURS REFERENCE SOURCE LOW HIGH: passes between LOW and HIGH
  awk -v q="$1" -v u="$2" -v x="$3" -v r="$4" -v s="$5" -v a="$6" -v b="$7" 'BEGIN {
    printf "%s,%s,%.10g,%s,%s,%s to %s,%s\n", q, u, x, r, s, a, b, (x != "" && x + 0 >= a + 0 && x + 0 <= b + 0) ? "yes" : "no" }' >>"$summary"
}
near() { # near QUANTITY UNIT OURS REFERENCE SOURCE TOLERANCE: relative
  awk -v q="$1" -v u="$2" -v x="$3" -v r="$4" -v s="$5" -v t="$6" 'BEGIN { d = x / r - 1; if (d < 0) d = -d
    printf "%s,%s,%.10g,%.10g,%s,%g relative,%s\n", q, u, x, r, s, t, (x != "" && d <= t) ? "yes" : "no" }' >>"$summary"
}
shown() { # shown QUANTITY UNIT OURS REFERENCE SOURCE: no tolerance, no verdict
  awk -v q="$1" -v u="$2" -v x="$3" -v r="$4" -v s="$5" 'BEGIN { printf "%s,%s,%.10g,%s,%s,,\n", q, u, x, r, s }' >>"$summary"
}
finish() {
  cat "$summary"
  ! grep -q ',no$' "$summary"
}
