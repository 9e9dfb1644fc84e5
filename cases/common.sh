# shellcheck shell=bash
# shellcheck disable=SC2016,SC2154 # awk in single quotes; $runs is of whoever sources this
# What all cases share. Sourced, by bash: the table summary.csv with its verdicts, numbers of a run, small sums.
#
# A case's script writes everything it has to write, and ends with `finish`, which leaves with 1 where a number misses
# its tolerance.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# summary_begin FILE: a new table. A field with a comma stands in double quotes. ours is written with $digits digits
# where that is set, and as it is given where not, or where it is no number. pass is yes or no, and empty where there is
# no tolerance.
summary_begin() {
  summary=$1
  echo "quantity,unit,ours,reference,source,tolerance,pass" >"$summary"
}
# summary_line RULE QUANTITY UNIT OURS REFERENCE SOURCE ...: what row, at_most, near, same and shown have in common.
# RULE is awk: it sets
# `tolerance` and, from x (ours), `passes`; a, b are what follows SOURCE. What is no number passes no range.
summary_line() {
  awk -v q="$2" -v u="$3" -v x="$4" -v r="$5" -v s="$6" -v a="${7-}" -v b="${8-}" -v digits="${digits-}" '
    function field(t) { if (t ~ /[,"]/) { gsub(/"/, "\"\"", t); t = "\"" t "\"" } return t }
    BEGIN {
      is_number = x ~ /^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$/
      tolerance = ""; passes = 0
      '"$1"'
      ours = is_number && digits ? sprintf("%." digits "g", x) : x
      print field(q) "," field(u) "," field(ours) "," field(r) "," field(s) "," field(tolerance) "," \
        (tolerance == "" ? "" : passes ? "yes" : "no") }' >>"$summary"
}
# row QUANTITY UNIT OURS REFERENCE SOURCE [LOW [HIGH]]: passes between LOW and HIGH; without HIGH from LOW on; shown
# without both
row() {
  summary_line 'if (a != "") { tolerance = b == "" ? ">= " a : a " to " b;
    passes = is_number && x + 0 >= a + 0 && (b == "" || x + 0 <= b + 0) }' "$@"
}
at_most() { # at_most QUANTITY UNIT OURS REFERENCE SOURCE LIMIT: passes up to LIMIT in magnitude
  summary_line 'tolerance = "at most " a; passes = is_number && x + 0 <= a + 0 && -x <= a + 0' "$@"
}
near() { # near QUANTITY UNIT OURS REFERENCE SOURCE TOLERANCE: relative
  summary_line 'd = x / r - 1; if (d < 0) d = -d; tolerance = sprintf("%g relative", a);
    passes = is_number && d <= a + 0
    if (digits) r = sprintf("%." digits "g", r)' "$@"
}
same() { # same QUANTITY UNIT OURS REFERENCE SOURCE: passes where OURS is the word REFERENCE
  summary_line 'tolerance = "the same"; passes = x "" == r ""' "$@"
}
shown() { # shown QUANTITY UNIT OURS REFERENCE SOURCE: no tolerance, no verdict
  summary_line '' "$@"
}
# finish: the table, and 1 where a row of it misses its tolerance
finish() {
  cat "$summary"
  ! grep -q ',no$' "$summary"
}

# is_done FOLDER: a run there has come to its end
is_done() { grep -qs '"status": *"done"' "$1/run.json"; }
# number FILE KEY, text FILE KEY: of a run.json, the first of that name
number() { sed -n "s/.*\"$2\": *\([-0-9.e+]*\).*/\1/p" "$1" | head -n 1; }
text() { sed -n "s/.*\"$2\": *\"\(.*\)\".*/\1/p" "$1" | head -n 1; }
# json NAME KEY: a number of the run $runs/NAME
json() { number "$runs/$1/run.json" "$2"; }

# calc EXPRESSION, of awk, with pi
calc() { awk "BEGIN { pi = atan2(0, -1); printf \"%.12g\\n\", $1 }"; }
# scaled FACTOR [VALUE]: their product, nothing without a value
scaled() { [ -z "${2-}" ] || awk -v f="$1" -v v="$2" 'BEGIN { printf "%.6g\n", f * v }'; }

# For awk -F, over tables with two lines of header, several one after the other: k[NAME] is a column's number.
# shellcheck disable=SC2034 # for whoever sources this
names='FNR == 1 { delete k; for (i = 1; i <= NF; i++) k[$i] = i } FNR <= 2 { next }'
# h5_values FILE DATASET FORMAT COLUMNS: of an HDF5 file, COLUMNS numbers a line. Needs h5dump (Debian: hdf5-tools).
h5_values() {
  local dashes
  dashes=$(printf ' -%.0s' $(seq "$4"))
  # shellcheck disable=SC2086 # as many words as columns
  h5dump -y -w 0 -m "$3" -d "$2" "$1" | sed -n '/DATA {/,/}/p' | tr -d '{}DAT ' | tr ',' '\n' | grep -v '^$' |
    paste -d ' ' $dashes
}
