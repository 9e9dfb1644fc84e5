#!/usr/bin/env bash
# Checks that the scripts of the cases (bash, awk, Python) that git tracks do not grow: a new case is a scene and a
# study, and has a script only for its own arithmetic. A script that several cases link to counts once. Prints the
# number of lines; leaves with 1 above the bound, and then prints the ten longest scripts. Whoever shortens the scripts
# lowers the bound.
#   tools/scripts.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
most=3761

scripts() {
    git ls-files -s 'cases/*.sh' 'cases/*.awk' 'cases/*.py' | sed -n 's/^100[0-9]* [^\t]*\t//p' | tr '\n' '\0'
}
lines=$(scripts | xargs -0 cat | wc -l)
echo "cases: $lines lines of scripts, at most $most are allowed"
if [ "$lines" -gt "$most" ]; then
    scripts | while IFS= read -r -d '' script; do
        printf '%6d %s\n' "$(wc -l <"$script")" "$script"
    done | sort -rn | awk 'NR <= 10'
    exit 1
fi
