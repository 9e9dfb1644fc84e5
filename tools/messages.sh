#!/usr/bin/env bash
# Checks that the messages in docs/troubleshooting.md are those of the program: each of its headings in backquotes must
# stand in a source file, with … for what is filled in. Those of MPI are left out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# all strings of the sources, joined where they go on in the next line; then what stands between two quotation marks is
# a line, in which a pattern is found much sooner
rooms=(base files scene physics stokes fluid solid meshless cracks ibm coupling program postproc study)
git ls-files "${rooms[@]/%//*.c}" | xargs cat | tr '\n' ' ' |
    sed 's/" *"//g; s/\\"/"/g' >"$work/whole"
tr '"' '\n' <"$work/whole" | sort -u >"$work/sources"

count=0 wrong=0
while IFS= read -r message; do
    count=$((count + 1))
    # a pattern of the whole message: a conversion of printf or anything short where … stands
    pattern=$(printf '%s' "$message" | sed 's/[][\.*^$+?(){}|]/\\&/g; s/^…//; s/…$//; s/…/[^"]{1,40}/g')
    in=$work/sources
    [[ $message != *\"* ]] || in=$work/whole
    grep -qE -- "$pattern" "$in" || {
        echo "docs/troubleshooting.md: no source says: $message"
        wrong=$((wrong + 1))
    }
done < <(awk '
    /^## / { mpi = /^## MPI/ }
    /^### `.*`$/ && (!mpi || /threads/) { gsub(/^### `|`$/, ""); print }' docs/troubleshooting.md)
if [ "$count" = 0 ] || [ "$wrong" -gt 0 ]; then
    echo "$wrong of $count messages are not the program's"
    exit 1
fi
echo "$count messages are the program's"
