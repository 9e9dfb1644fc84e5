# shellcheck shell=bash
# shellcheck disable=SC2016 # awk in single quotes
# What the scripts of cases share, sourced by bash: numbers of a run, small calculations.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# is_done FOLDER: whether the run in FOLDER is finished
is_done() { grep -qs '"status": *"done"' "$1/run.json"; }
# number FILE KEY, text FILE KEY: the first value of KEY in a run.json
number() { sed -n "s/.*\"$2\": *\([-0-9.e+]*\).*/\1/p" "$1" | head -n 1; }
text() { sed -n "s/.*\"$2\": *\"\(.*\)\".*/\1/p" "$1" | head -n 1; }

# calc EXPRESSION: the value of an awk expression, which may use pi
calc() { awk "BEGIN { pi = atan2(0, -1); printf \"%.12g\\n\", $1 }"; }
# scaled FACTOR [VALUE]: FACTOR times VALUE; prints nothing without VALUE
scaled() { [ -z "${2-}" ] || awk -v f="$1" -v v="$2" 'BEGIN { printf "%.6g\n", f * v }'; }

# Start of an awk -F, program that reads one or more tables with two lines of header. k[NAME] is the number of a column.
# shellcheck disable=SC2034 # for whoever sources this
names='FNR == 1 { delete k; for (i = 1; i <= NF; i++) k[$i] = i } FNR <= 2 { next }'
# h5_values FILE DATASET FORMAT COLUMNS: prints a dataset of an HDF5 file, COLUMNS numbers a line. If it cannot be read,
# the script ends: whoever reads <(h5_values ...) does not see a failure, and would go on with an empty table.
h5_values() {
  local values
  values=$(h5dump -y -w 0 -m "$3" -d "$2" "$1") ||
    { echo "$0: $2 of $1 cannot be read (h5dump is in Debian's hdf5-tools)" >&2 && kill $$; }
  sed -n '/DATA {/,/}/p' <<<"$values" | tr -d '{}DAT ' | tr ',' '\n' | grep -v '^$' |
    awk -v n="$4" '{ printf "%s%s", $0, NR % n ? " " : "\n" }'
}
