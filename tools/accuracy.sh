#!/usr/bin/env bash
# Writes docs/accuracy.md from the results of all cases, and counts of tolerances into README.md, paper.md and
# cases/verification/README.md. Runs nothing. With --check it only leaves with 1 if a page is not what it would write.
#   tools/accuracy.sh [--check]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Folders of all cases whose results/summary.csv has a row; by folder, how many rows have the verdict yes, and no.
all=() held=0 gates=0
declare -A met missed
while read -r folder yes no; do
  all+=("$folder") met[$folder]=$yes missed[$folder]=$no
  held=$((held + yes)) gates=$((gates + yes + no))
done < <(awk '
  FNR == 1 { folder[++k] = FILENAME; sub("/results/summary.csv$", "", folder[k]); next }
  { rows[k]++ } /,yes$/ { yes[k]++ } /,no$/ { no[k]++ }
  END { for (i = 1; i <= k; i++) if (rows[i]) print folder[i], yes[i] + 0, no[i] + 0 }
  ' cases/{*,stability/*,verification/*}/results/summary.csv)
mapfile -t verification < <(printf '%s\n' "${all[@]}" | grep '^cases/verification/')
# rows FOLDER: sets `rows`, how many numbers of the folder's cases are in shown.csv
rows() {
  local lines=(header)
  [ ! -f "$1/results/shown.csv" ] || mapfile -t lines <"$1/results/shown.csv"
  rows=$((${#lines[@]} - 1))
}
# counted FILE HELD GATES: the page FILE with its "N of M tolerances" made anew
counted() { sed "s/[0-9]* of [0-9]* tolerances/$2 of $3 tolerances/" "$1"; }

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
  local dir=$1 summary=$1/results/summary.csv title csv limits
  read -r title <"$dir/README.md"
  echo
  echo "## ${title#\# }"
  echo
  echo "[${dir##*/}](../$dir): ${met[$dir]} of $((met[$dir] + missed[$dir])) tolerances met ([summary](../$summary))."
  if [ "${missed[$dir]}" != 0 ]; then
    echo
    awk -v page=1 -f tools/csv.awk -f tools/misses.awk "$dir/misses.csv" "$summary"
    echo
    paragraph "$dir" 'Missed' | moved "$dir"
  fi
  while read -r csv; do
    if grep -q '^# advice on' "$csv" || [ -n "$(plot "$csv")" ]; then study "$csv"; fi
  done < <(grep -ls '^method,level' "$dir"/results/*.csv)
  limits=$(paragraph "$dir" 'Limitations')
  [ -z "$limits" ] || { echo; moved "$dir" <<<"$limits"; }
}
accuracy() {
  cat <<END
# Accuracy

Made by \`tools/accuracy.sh\` from the results of all cases, not by hand.

**$held of $gates tolerances are met.** A tolerance says how far a number of a case may be from its reference: an exact
solution, another program, a thesis or an experiment. Each such number has a verdict in \`results/summary.csv\` of its
case. Numbers that show a trend, or that have no reference, are in \`results/shown.csv\` and do not count. Each miss is
listed below with its reason, whether that was tested, and the range that it may not leave (\`misses.csv\` of its case).

| the tolerance compares with | tolerances | met |
|---|--:|--:|
END
  awk -f tools/csv.awk -f tools/kinds.awk cases/kinds.csv "${all[@]/%//results/summary.csv}" | sed -f tools/kinds.sed
  cat <<END

| case | tolerances | met | missed | only shown |
|---|--:|--:|--:|--:|
END
  for dir in "${all[@]}"; do
    rows "$dir"
    echo "| [${dir#cases/}](../$dir) | $((met[$dir] + missed[$dir])) | ${met[$dir]} | ${missed[$dir]} | $rows |"
  done
  cat <<'END'

Below are the cases of [cases/verification](../cases/verification) first, then the others. Maps
of stability without a miss are in [stability.md](stability.md). The cost of an error is the
wall time of the steps of the cheapest run with a smaller error, by the named method at the named level. Times were
measured on the machine that each table of results names; errors do not depend on it.
END
  cat cases/verification/*/results/*.csv | sed -n 's/^# machine: \(.*\)/Machine: \1./p' | sort -u | sed 's/^/\n/'
  [ ! -f cases/verification/defaults.md ] || { echo; moved cases/verification <cases/verification/defaults.md; }
  awk -f tools/csv.awk -f tools/budget.awk cases/verification/cost/results/study_{first,hold,broken,settled,notch}.csv
  for dir in "${verification[@]}"; do case_section "$dir"; done
  for dir in "${all[@]}"; do
    [ "${dir#cases/verification/}" != "$dir" ] || [ ! -f "$dir/README.md" ] || case_section "$dir" # docs/stability.md
  done
}
accuracy >"$work/accuracy.md"
counted README.md "$held" "$gates" >"$work/README.md"
main=${met[cases/porous_channel]} of=$((met[cases/porous_channel] + missed[cases/porous_channel]))
counted docs/paper/paper.md "$held" "$gates" | sed "s/[0-9]* of its [0-9]* tol/$main of its $of tol/" >"$work/paper.md"
held_here=0 gates_here=0
for dir in "${verification[@]}"; do
  held_here=$((held_here + met[$dir])) gates_here=$((gates_here + met[$dir] + missed[$dir]))
done
counted cases/verification/README.md "$held_here" "$gates_here" >"$work/verification.md"
code=0
while read -r made page; do
  if [ "${1-}" != --check ]; then
    cp "$work/$made" "$page"
  elif ! cmp -s "$work/$made" "$page"; then
    diff -u "$page" "$work/$made" | head -n 20
    echo "$page: not what tools/accuracy.sh makes of the results; run it"
    code=1
  fi
done <<'END'
accuracy.md docs/accuracy.md
README.md README.md
paper.md docs/paper/paper.md
verification.md cases/verification/README.md
END
[ "${1-}" = --check ] || echo "$held of $gates tolerances are met"
exit $code
