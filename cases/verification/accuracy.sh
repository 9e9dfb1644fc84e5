#!/usr/bin/env bash
# Writes docs/accuracy.md from the results of all cases. Runs nothing. usage: cases/verification/accuracy.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
page=docs/accuracy.md work=$(mktemp)
trap 'rm -f "$work"' EXIT

# paragraph FOLDER WORD: the paragraph of FOLDER/README.md that begins with WORD, bold or not, up to the next blank line
paragraph() { awk -v word="$2" 'index($0, word) == 1 || index($0, "**" word) == 1 { on = 1 } /^$/ { on = 0 }
  on' "$1/README.md"; }
# moved FOLDER: copies a page of FOLDER; relative links are changed so that they hold in docs/
moved() {
  awk -v folder="$1" '
    function seen_from_docs(link,  part, n, i, k, path, up) {
      if (link ~ /^(#|[a-z]+:)/) return link
      n = split(folder "/" link, part, "/")
      for (i = 1; i <= n; i++)
        if (part[i] == "..") k--
        else if (part[i] != "" && part[i] != ".") path[++k] = part[i]
      up = path[1] == "docs" ? "" : "../"
      for (i = up == "" ? 2 : 1; i <= k; i++) up = up path[i] (i < k ? "/" : "")
      return up
    }
    { line = ""
      while (match($0, /\]\([^()]*\)/)) {
        line = line substr($0, 1, RSTART + 1) seen_from_docs(substr($0, RSTART + 2, RLENGTH - 3)) ")"
        $0 = substr($0, RSTART + RLENGTH)
      }
      print line $0 }'
}
plot() { # plot CSV: the plot of a study's first quantity: NAME.png, or NAME_QUANTITY.png if there are several
  local name=${1%.csv} first png
  first=$(sed -n 's/^# reference of \([^:]*\):.*/\1/p' "$1" | sed -n '1{s/[^A-Za-z0-9._]/-/g;p}')
  for png in "$name.png" "${name}_$first.png"; do
    if [ -f "$png" ]; then printf '\n![error against wall time](../%s)\n' "$png"; fi
  done
}
study() { # study CSV: title, machine, one line of advice for each quantity, plots
  echo
  echo "**$(sed -n '1s/^# //p' "$1")**"
  echo
  grep '^# advice on ' "$1" | sed -n '1,3s/^# advice on \([^:]*\): \(.*\)/* \1: \2./p' || true
  plot "$1"
}
case_section() {
  local dir=$1 summary=$1/results/summary.csv passed missed
  echo
  echo "## $(sed -n '1s/^# //p' "$dir/README.md")"
  echo
  passed=$(grep -c ',yes$' "$summary" || true) missed=$(grep -c ',no$' "$summary" || true)
  echo "[$(basename "$dir")](../$dir): $passed of $((passed + missed)) tolerances met ([summary](../$summary))."
  awk '/,no$/ { # quantity, unit, ours, reference, source, tolerance; a field with a comma is in quotes
      n = 0
      while (match($0, /^("([^"]|"")*"|[^,]*)(,|$)/) && RLENGTH > 0) {
        cell[++n] = substr($0, 1, RLENGTH)
        $0 = substr($0, RLENGTH + 1)
        sub(/,$/, "", cell[n])
        if (sub(/^"/, "", cell[n])) sub(/"$/, "", cell[n])
      }
      printf "* missed: %s: %s %s, asked %s\n", cell[1], cell[3], cell[2], cell[6] }' "$summary"
  for csv in "$dir"/results/*.csv; do
    if grep -qs '^method,level' "$csv"; then study "$csv"; fi
  done
  [ -z "$(paragraph "$dir" 'Limitations')" ] || { echo; paragraph "$dir" 'Limitations' | moved "$dir"; }
}
{
  cat <<'END'
# Accuracy

Made by `cases/verification/nightly.sh` from the results of the cases in [cases/verification](../cases/verification),
not by hand. What an error costs is the wall time of the steps of the cheapest run that stays below it, by the named
method at the named level; times are of the machine named in each table of results, errors are not.
END
  cat cases/verification/*/results/*.csv | sed -n 's/^# machine: \(.*\)/Machine: \1./p' | sort -u | sed 's/^/\n/'
  [ ! -f cases/verification/defaults.md ] || { echo; moved cases/verification <cases/verification/defaults.md; }
  for dir in cases/verification/*/; do
    [ ! -f "$dir/results/summary.csv" ] || case_section "${dir%/}"
  done
} >"$work"
cp "$work" "$page"
