#!/usr/bin/env bash
# Writes the tables of statements of two pages of cases/porous_channel and of docs/statements.md from the tables beside
# these pages and the results of the cases (tools/statements.awk). Runs nothing. With --check it writes nothing, and
# leaves with 1 if a page is not what it would write.
#   tools/statements.sh [--check]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C
made=$(mktemp)
trap 'rm -f "$made"' EXIT
code=0
for page in cases/porous_channel/{README,thesis}.md docs/statements.md; do
    awk -v page="$page" -f tools/csv.awk -f tools/statements.awk "$page" >"$made"
    if [ "${1-}" != --check ]; then
        cmp -s "$made" "$page" || cp "$made" "$page"
    elif ! diff -u "$page" "$made" | head -n 20; then
        code=1
    elif ! cmp -s "$made" "$page"; then
        echo "$page: not what tools/statements.sh makes of the results; run it"
        code=1
    fi
done
exit $code
