#!/usr/bin/env bash
# Checks the results of the cases that git tracks: each row of a summary.csv has the verdict yes or no, and a tolerance;
# no quantity is twice in it; each miss has a line in the case's misses.csv with its reason and a range that its value
# may not leave, and a case with misses a paragraph **Missed.** in its README.md; cases/kinds.csv says of each row what
# it compares with; docs/accuracy.md, README.md, docs/paper/paper.md and cases/verification/README.md are what
# tools/accuracy.sh makes of the results; the tables of statements are what tools/statements.sh makes of them.
# Prints what is wrong, and leaves with 1 if something is.
#   tools/verdicts.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

code=0
while read -r summary; do
    awk -v file="$summary" '
        NR == 1 { if ($0 != "quantity,unit,ours,reference,source,tolerance,pass") {
                    print file ":1: other columns"; bad = 1 }
                  next }
        !/,(yes|no)$/ || /,,(yes|no)$/ { print file ":" NR ": no verdict, or no tolerance: " $0; bad = 1 }
        { match($0, /^("([^"]|"")*"|[^,]*)/); name = substr($0, 1, RLENGTH) }
        seen[name]++ { print file ":" NR ": for the second time: " name; bad = 1 }
        END { exit bad }' "$summary" || code=1
    readme=${summary%/results/summary.csv}/README.md
    misses=${summary%/results/summary.csv}/misses.csv
    if [ -f "$misses" ]; then
        awk -v strict=1 -f tools/csv.awk -f tools/misses.awk "$misses" "$summary" || code=1
    elif grep -q ',no$' "$summary"; then
        echo "$misses: is missing, but $summary has a miss"
        code=1
    fi
    if grep -q ',no$' "$summary" && ! grep -qs '^\*\*Missed\.\*\*' "$readme"; then
        echo "$readme: no paragraph **Missed.**, but $summary has a miss"
        code=1
    fi
done < <(git ls-files 'cases/*summary.csv')
git ls-files -z 'cases/*summary.csv' |
    xargs -0 awk -v check=1 -f tools/csv.awk -f tools/kinds.awk cases/kinds.csv || code=1
tools/accuracy.sh --check || code=1
tools/statements.sh --check || code=1
exit $code
