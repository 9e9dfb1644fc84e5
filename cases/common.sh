# shellcheck shell=bash
# shellcheck disable=SC2016,SC2154 # awk in single quotes; $runs is of whoever sources this
# What all cases share, sourced by bash: summary.csv with its verdicts, shown.csv, numbers of a run, small calculations.
#
# A case's script writes all its files and then calls `finish`. `finish` returns 1 if a number misses its tolerance.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
of_misses=$(dirname "${BASH_SOURCE[0]}")/../tools

# summary_begin FILE: starts two tables, FILE for the judged numbers and beside it shown.csv (quick_shown.csv if FILE is
# quick.csv) for those without a tolerance. A field with a comma is put in double quotes. If $digits is set, the number
# in column ours is written with that many digits. Column pass of FILE is yes or no, never empty.
# Unless $again is set, a new $measured is started as well (measured.csv beside FILE by default); `kept` writes it.
summary_begin() {
  summary=$1 shown=${1%summary.csv}
  [ "$shown" != "$1" ] || shown=${1%.csv}_
  shown=${shown}shown.csv
  echo "quantity,unit,ours,reference,source,tolerance,pass" >"$summary"
  rm -f "$shown"
  measured=${measured:-$(dirname "$1")/measured.csv}
  [ "${again-}" ] || rm -f "$measured"
}
# summary_line RULE QUANTITY UNIT OURS REFERENCE SOURCE [A [B]]: prints one line; row, at_most, near and shown use
# it. RULE is awk code that sets `tolerance`, and sets `passes` from x (OURS), a (A) and b (B); an empty RULE leaves out
# both columns. A text that is not a number is in no range.
summary_line() {
  awk -v rule="${1:+judged}" -v q="$2" -v u="$3" -v x="$4" -v r="$5" -v s="$6" -v a="${7-}" -v b="${8-}" \
    -v digits="${digits-}" '
    function field(t) { if (t ~ /[,"]/) { gsub(/"/, "\"\"", t); t = "\"" t "\"" } return t }
    BEGIN {
      is_number = x ~ /^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$/
      tolerance = ""; passes = 0
      '"$1"'
      ours = is_number && digits ? sprintf("%." digits "g", x) : x
      line = field(q) "," field(u) "," field(ours) "," field(r) "," field(s)
      if (!rule) { print line; exit }
      if (tolerance == "") { print "no tolerance: " q > "/dev/stderr"; exit 1 }
      print line "," field(tolerance) "," (passes ? "yes" : "no") }'
}
# row QUANTITY UNIT OURS REFERENCE SOURCE LOW [HIGH]: passes if LOW <= OURS <= HIGH; without HIGH if LOW <= OURS
row() {
  summary_line 'if (a != "") { tolerance = b == "" ? ">= " a : a " to " b;
    passes = is_number && x + 0 >= a + 0 && (b == "" || x + 0 <= b + 0) }' "$@" >>"$summary"
}
at_most() { # at_most QUANTITY UNIT OURS REFERENCE SOURCE LIMIT: passes if |OURS| <= LIMIT
  summary_line 'tolerance = "at most " a; passes = is_number && x + 0 <= a + 0 && -x <= a + 0' "$@" >>"$summary"
}
near() { # near QUANTITY UNIT OURS REFERENCE SOURCE TOLERANCE: passes if |OURS/REFERENCE - 1| <= TOLERANCE
  summary_line 'd = x / r - 1; if (d < 0) d = -d; tolerance = sprintf("%g relative", a);
    passes = is_number && d <= a + 0
    if (digits) r = sprintf("%." digits "g", r)' "$@" >>"$summary"
}
# shown QUANTITY UNIT OURS REFERENCE SOURCE: a number without a tolerance, in shown.csv: it shows a trend, or has no
# reference
shown() {
  [ -f "$shown" ] || echo "quantity,unit,ours,reference,source" >"$shown"
  summary_line '' "$@" >>"$shown"
}
# missed FILE: the quantities of a table that miss their tolerance, one a line
missed() { sed -n 's/,no$//p' "$1" | sed 's/^"\(\([^"]\|""\)*\)".*/\1/; t; s/,.*//' | sort; }
# finish: prints the tables; returns 1 if a row misses its tolerance. If $known is another summary.csv, rows that miss
# theirs in it too do not count, as long as they stay in the range that the case's misses.csv gives them.
finish() {
  cat "$summary"
  [ ! -f "$shown" ] || cat "$shown"
  if [ "${known-}" ]; then
    local new misses=${known%/results/*}/misses.csv
    new=$(comm -23 <(missed "$summary") <(missed "$known"))
    [ ! -f "$misses" ] || new+=$(awk -f "$of_misses/csv.awk" -f "$of_misses/misses.awk" "$misses" "$summary" || true)
    [ -z "$new" ] || { printf 'missed here, met in %s:\n%s\n' "$known" "$new" >&2; return 1; }
  else
    ! grep -q ',no$' "$summary"
  fi
}
# kept KEY COMMAND...: prints the one line that COMMAND prints, and keeps it in $measured under KEY (without ").
# If $again is set, as by `run.sh --summary`, it prints what is kept, and COMMAND does not run.
kept() {
  local key=$1 value
  shift
  if [ "${again-}" ]; then
    KEY=\"$key\", awk 'index($0, ENVIRON["KEY"]) == 1 { print substr($0, length(ENVIRON["KEY"]) + 1); found = 1; exit }
      END { exit !found }' "$measured" && return
    echo "$measured holds no \"$key\": run without --summary" >&2
    kill $$ # in a substitution, exit would leave that alone
  else
    value=$("$@") || { echo "$key: $* failed" >&2; kill $$; }
    echo "$value"
    grep -qsF "\"$key\"," "$measured" || echo "\"$key\",$value" >>"$measured"
  fi
}

# is_done FOLDER: whether the run in FOLDER is finished
is_done() { grep -qs '"status": *"done"' "$1/run.json"; }
# number FILE KEY, text FILE KEY: the first value of KEY in a run.json
number() { sed -n "s/.*\"$2\": *\([-0-9.e+]*\).*/\1/p" "$1" | head -n 1; }
text() { sed -n "s/.*\"$2\": *\"\(.*\)\".*/\1/p" "$1" | head -n 1; }

# cell STUDY COLUMN METHOD LEVEL QUANTITY: a cell of the table $tables/STUDY.csv of a study.
cell() {
  awk -F, -v c="$2" -v m="$3" -v l="$4" -v q="$5" '/^#/ { next }
    !at { for (i = 1; i <= NF; i++) if ($i == c) at = i; next }
    $1 == m && $2 == l && $4 == q { print $at; found = 1 } END { exit !found }' "$tables/$1.csv" ||
    { echo "$1: no $2 of $3, $4, $5" >&2; kill $$; }
}

# calc EXPRESSION: the value of an awk expression, which may use pi
calc() { awk "BEGIN { pi = atan2(0, -1); printf \"%.12g\\n\", $1 }"; }
# scaled FACTOR [VALUE]: FACTOR times VALUE; prints nothing without VALUE
scaled() { [ -z "${2-}" ] || awk -v f="$1" -v v="$2" 'BEGIN { printf "%.6g\n", f * v }'; }

# Start of an awk -F, program that reads one or more tables with two lines of header. k[NAME] is the number of a column.
# shellcheck disable=SC2034 # for whoever sources this
names='FNR == 1 { delete k; for (i = 1; i <= NF; i++) k[$i] = i } FNR <= 2 { next }'
# h5_values FILE DATASET FORMAT COLUMNS: prints a dataset of an HDF5 file, COLUMNS numbers a line. Needs h5dump (Debian:
# hdf5-tools).
h5_values() {
  local dashes
  dashes=$(printf ' -%.0s' $(seq "$4"))
  # shellcheck disable=SC2086 # as many words as columns
  h5dump -y -w 0 -m "$3" -d "$2" "$1" | sed -n '/DATA {/,/}/p' | tr -d '{}DAT ' | tr ',' '\n' | grep -v '^$' |
    paste -d ' ' $dashes
}
