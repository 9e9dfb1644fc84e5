#!/usr/bin/env bash
# tools/names.sh [build]: every public function and table must stand in the file that its name gives.
#
# A file room/folder/stem.c owns the names that are, or begin with (an underscore follows),
#     room_folder_stem     always
#     room_stem            the files of a room that have the same stem share these names
#     folder_stem, stem    the same without the room, in the rooms that are listed in `short` below
# A word that repeats the one before is left out: solid/contact/contact.c owns solid_contact. The file with the longest
# such beginning owns the name. A name without such a file belongs to the room's own file: solid_new to solid/solid.c.
# Public names are read from the objects of a build (nm). Inline functions are read from the headers: stem.h owns what
# stem.c does, and the headers listed in `common` own what their folder's own file does.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build}
rooms="base scene physics stokes fluid solid cracks meshless ibm coupling postproc program"
nested="base/files program/bench program/study" # rooms of their own
short="base files coupling bench program"
common="state internal parts input"

[ -d "$build/CMakeFiles" ] || { echo "names: there is no build in $build" >&2; exit 1; }
# shellcheck disable=SC2086 # a list
names() {
    git ls-files $rooms | sed -n 's/^\(.*\)\.[ch]$/file \1/p' | sort -u
    find "$build/CMakeFiles" -path '*/frana_*.dir/*' -name '*.c.o' -exec nm -A -g --defined-only {} + |
        sed -n 's|^[^:]*/frana_[a-z]*\.dir/\([^:]*\)\.c\.o:[0-9a-f]* [A-Z] \([a-z][a-z_0-9]*\)$|name \1 \2 c|p'
    # shellcheck disable=SC2016 # awk's
    git ls-files -z $rooms | grep -z '\.h$' | xargs -0 awk '
        function function_name(text) {
            if (!match(text, /[a-z_0-9]+\(/)) return ""
            return substr(text, RSTART, RLENGTH - 1)
        }
        FNR == 1 { wanted = 0; path = FILENAME; sub(/\.h$/, "", path) }
        /^static inline/ { wanted = 1; sub(/__attribute__\(\([a-z_]*\)\) */, "") }
        /NAME\(/ { wanted = 0 }
        wanted { name = function_name($0); if (name != "") { print "name", path, name, "h"; wanted = 0 } }'
}
names | awk -v nested="$nested" -v short="$short" -v common="$common" '
    function joined(a, b) { return a == "" || a == b ? b : a "_" b }
    function add(key, path) { if (index(owners[key], " " path " ") == 0) owners[key] = owners[key] " " path " " }
    BEGIN {
        n = split(short, list, " ")
        for (i = 1; i <= n; i++) is_short[list[i]] = 1
        n = split(nested, list, " ")
        for (i = 1; i <= n; i++) is_nested[list[i]]
        n = split(common, list, " ")
        for (i = 1; i <= n; i++) is_common[list[i]] = 1
    }
    # The path from its room on.
    function within(path, part) {
        split(path, part, "/")
        return (part[1] "/" part[2]) in is_nested ? substr(path, length(part[1]) + 2) : path
    }
    $1 == "file" {
        path[++files] = $2
        exists[$2]
        split(within($2), part, "/")
        is_room[part[1]]
    }
    $1 == "name" && ($2 in exists) && !seen[$2, $3]++ { at[++count] = $2; name[count] = $3; kind[count] = $4 }
    END {
        for (f = 1; f <= files; f++) {
            n = split(within(path[f]), part, "/")
            folders = ""
            for (i = 2; i < n; i++) folders = joined(folders, part[i])
            if (is_common[part[n]]) add(folders == "" ? part[1] : joined(part[1], folders), path[f])
            if (is_common[part[n]] && is_short[part[1]] && folders != "") add(folders, path[f])
            inner = joined(folders, part[n])
            add(joined(part[1], inner), path[f])
            add(joined(part[1], part[n]), path[f])
            if (!is_short[part[1]] || part[n] in is_room) continue
            add(inner, path[f])
            add(part[n], path[f])
        }
        for (i = 1; i <= count; i++) {
            for (key = name[i]; !(key in owners) && key ~ /[_0-9]/; )
                if (!sub(/[0-9]+$/, "", key) && !sub(/_[^_]*$/, "", key)) break
            if (key in owners && index(owners[key], " " at[i] " ")) continue
            owner = key in owners ? owners[key] : " no file"
            gsub(/ +/, " ", owner)
            sub(/ $/, "", owner)
            printf "%s.%s: %s belongs to%s\n", at[i], kind[i], name[i], owner
            wrong++
        }
        if (wrong) printf "names: %d of %d public names stand in another file than their name gives\n", wrong, count
        exit wrong > 0
    }'
