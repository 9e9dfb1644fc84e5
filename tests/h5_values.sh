#!/usr/bin/env bash
# A script of a case that reads fields ends, with a message, where h5dump is missing or the dataset is. It does not go
# on with an empty table.
# usage: h5_values.sh SOURCE
set -euo pipefail
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cat >"$dir/draw.sh" <<EOF
. "$1/cases/common.sh"
paste -d ' ' <(h5_values field.hdf /VTKHDF/Points %.9g 3) <(h5_values field.hdf /damage %.9g 1) | cat >"$dir/table"
echo drawn
EOF
ends() { # ends WORDS: draw.sh ends with a message that has WORDS
    if said=$(bash "$dir/draw.sh" 2>&1); then echo "it went on: $said" && exit 1; fi
    grep -q "$1" <<<"$said" || { echo "other words: $said" && exit 1; }
}
stand_in() { printf '#!/bin/sh\n%s\n' "$1" >"$dir/bin/h5dump" && chmod +x "$dir/bin/h5dump"; } # stand_in COMMAND
mkdir "$dir/bin"
PATH=$dir/bin:$PATH
stand_in 'exit 127'
ends 'hdf5-tools'
stand_in 'case "$*" in *damage*) exit 1 ;; *) echo "DATA {"; echo "1, 2, 3,"; echo "4, 5, 6"; echo "}" ;; esac'
ends '/damage of field.hdf'
stand_in 'echo "DATA {"; echo "1, 2, 3,"; echo "4, 5, 6"; echo "}"'
bash "$dir/draw.sh" | grep -qx drawn
diff <(printf '1 2 3 1\n4 5 6 2\n 3\n 4\n 5\n 6\n') "$dir/table"
echo ok
