#!/usr/bin/env bash
# tools/circles.sh [build]: no two files of a room may use each other's functions or tables, nor may more files in a
# circle. Read from the objects of a build (nm), sorted by tsort, which says where the circles are.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build}
[ -d "$build/CMakeFiles" ] || { echo "circles: there is no build in $build" >&2; exit 1; }
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# user, definer, symbol
find "$build/CMakeFiles" -path '*/frana_*.dir/*' -name '*.c.o' -exec nm -A -g {} + |
    sed -n 's|^[^:]*/frana_[a-z]*\.dir/\([^:]*\.c\)\.o:[0-9a-f ]* \([A-Z]\) \([a-z].*\)$|\1 \2 \3|p' |
    awk '{
            if (!($1 in exists)) {
                exists[$1] = (getline line < $1) >= 0 # objects of removed files may be left in the build
                close($1)
            }
            if (!exists[$1]) next
        }
        $2 != "U" { definer[$3] = $1 }
        $2 == "U" { user[++n] = $1; symbol[n] = $3 }
        END {
            for (i = 1; i <= n; i++)
                if (symbol[i] in definer && definer[symbol[i]] != user[i]) print user[i], definer[symbol[i]], symbol[i]
        }' >"$work/uses"
if awk '{ print $1, $2 }' "$work/uses" | tsort >/dev/null 2>"$work/loops"; then exit 0; fi
echo "circles: files that use each other (the user, what it uses, the file that has it):"
awk 'FNR == NR { if ($0 !~ /loop:$/) in_loop[$NF]; next }
    ($1 in in_loop) && ($2 in in_loop) { print "  " $1 ": " $3 " of " $2 }' "$work/loops" "$work/uses"
exit 1
