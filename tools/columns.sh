#!/usr/bin/env bash
# Checks that no line of a source that git tracks is longer than 120 columns or has a tab. Prints file:line: columns of
# each such line, and exits with 1 if there is one. Columns are UTF-8 characters, not bytes. Lines between clang-format
# off and clang-format on (tables) are not checked. Sources are C, CMake and shell files, awk and gnuplot scripts.
#   tools/columns.sh [FILE ...]
# shellcheck disable=SC2016 # awk in single quotes
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C
most=120

# All output is collected first: a reader that stops early (head) then gets it without a message of xargs.
found=$(
    if [ $# -gt 0 ]; then
        printf '%s\0' "$@"
    else
        git ls-files -z '*.c' '*.h' '*.cmake' '*.sh' '*.awk' '*.gp' 'CMakeLists.txt' '*/CMakeLists.txt' .ci/run
    fi | xargs -0 awk -v most=$most '
        FNR == 1 { off = 0 }
        /clang-format off/ { off = 1 }
        /clang-format on/ { off = 0 }
        off { next }
        /\t/ { printf "%s:%d: a tab\n", FILENAME, FNR }
        length($0) > most {
            line = $0
            gsub(/[\200-\277]/, "", line)
            if (length(line) > most) printf "%s:%d: %d columns\n", FILENAME, FNR, length(line) }' /dev/null
)
[ -n "$found" ] || exit 0
echo "lines of sources have at most $most columns and no tabs" >&2
printf '%s\n' "$found" 2>/dev/null || true # the reader may have stopped
exit 1
