#!/usr/bin/env bash
# Lists the results of cases that are older than what they depend on: for each folder of results the revision that made
# its numbers, and the rooms with later commits. The revision is the one in the heads of the studies' tables; where git
# does not know it, because a rebase made it again, it is the commit that last changed the table. Without such a table
# it is the commit that last changed measured.csv or summary.csv, and whose message has no line "No number changes."
# Rooms follow from the case's scenes: a section fluid needs fluid, one for a solid needs solid, both need ibm and
# coupling, fluid in cracks needs cracks.
# A list to choose from, not a check: most commits change no result. Always leaves with 0.
#   tools/stale.sh [CASE ...]      cases/verification/cost, ...; all without
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# revision FOLDER: the oldest revision among its studies' tables
revision() {
    local table r at oldest='' least=''
    for table in "$1"/study*.csv; do
        r=$(sed -n 's/^# frana: .*revision \([0-9a-f]*\).*/\1/p' "$table" 2>/dev/null)
        [ "$r" ] || continue
        git cat-file -e "$r^{commit}" 2>/dev/null || r=$(git log -1 --format=%h -- "$table")
        at=$(git log -1 --format=%ct "$r")
        if [ -z "$least" ] || [ "$at" -lt "$least" ]; then least=$at oldest=$r; fi
    done
    [ "$oldest" ] || oldest=$(git log -1 --format=%h --invert-grep --grep='^No number changes[.]$' -- \
        "$1/measured.csv" "$1/limits.csv" "$1/summary.csv")
    echo "$oldest"
}
# rooms CASE: the folders of sources that its scenes use
rooms() {
    local scenes
    scenes=$(cat "$1"/*.yaml 2>/dev/null || true)
    grep -q '^fluid:' <<<"$scenes" && echo fluid
    grep -q '^solid:' <<<"$scenes" && echo solid physics
    grep -q '^fluid:' <<<"$scenes" && grep -q '^solid:' <<<"$scenes" && echo ibm coupling
    grep -q 'crack_fluid:' <<<"$scenes" && echo cracks
    grep -qE '^nonlocal:|element_free' <<<"$scenes" && echo meshless
    grep -qE 'permeability' "$1"/run.sh 2>/dev/null && echo stokes
    true
}
mapfile -t folders < <(ls -d cases/*/results cases/*/*/results)
[ $# = 0 ] || folders=("${@/%//results}")
for folder in "${folders[@]}"; do
    case=${folder%/results} later=''
    made=$(revision "$folder")
    for room in $(rooms "$case"); do
        n=$(git rev-list --count "$made..HEAD" -- "$room/*.c" "$room/*.h")
        [ "$n" = 0 ] || later="$later $room $n"
    done
    [ ! "$later" ] || printf '%-36s %s %s  later commits:%s\n' "${case#cases/}" "$made" \
        "$(git log -1 --format=%cs "$made")" "$later"
done
