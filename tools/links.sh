#!/usr/bin/env bash
# Checks the links of all Markdown files that git tracks: relative paths must exist, and #anchors must be headings,
# named as GitHub names them. Sources that a page names in backquotes, as `ibm/sweep.c` or `sweep.c`, must exist too.
# Prints file:line of each that does not hold, and leaves with 1 if there is one. Links to other hosts are not followed.
#   tools/links.sh [FILE.md ...]
# shellcheck disable=SC1112 # the quotes are those of headings
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C

if [ $# -gt 0 ]; then files=("$@"); else mapfile -t files < <(git ls-files '*.md'); fi
declare -A known heading # pages whose headings are known; PAGE#NAME of each heading

# links FILE: "line target" of each link outside of code
links() {
    awk '
        /^ *(```|~~~)/ { code = !code; next }
        code || /^    / && !list { next }
        { list = /^ *([-*]|[0-9]+\.) / || list && /^ / }
        { gsub(/`[^`]*`/, "")
          while (match($0, /\]\([^ ()]*(\([^ ()]*\)[^ ()]*)*( +"[^"]*")?\)/)) {
              target = substr($0, RSTART + 2, RLENGTH - 3)
              $0 = substr($0, RSTART + RLENGTH)
              sub(/ +".*/, "", target)
              gsub(/[<>]/, "", target)
              print FNR, target
          } }' "$1"
}

# anchors FILE: the names of its headings, and the ids it gives by hand
anchors() {
    awk '
        /^ *(```|~~~)/ { code = !code; next }
        code { next }
        { line = $0
          while (match(line, /<a +(id|name)="[^"]*"/)) {
              id = substr(line, RSTART, RLENGTH)
              line = substr(line, RSTART + RLENGTH)
              gsub(/.*="|"$/, "", id)
              print id
          } }
        /^#+ / {
            sub(/^#+ +/, "")
            sub(/ +#* *$/, "")
            while (match($0, /\[[^]]*\]\([^)]*\)/)) {
                text = substr($0, RSTART + 1, RLENGTH)
                sub(/\].*/, "", text)
                $0 = substr($0, 1, RSTART - 1) text substr($0, RSTART + RLENGTH)
            }
            # signs of more than one byte that are no letters, then those of one byte
            gsub(/–|—|‘|’|“|”|…|×|·|→|←|√|∞|≤|≥|≈|±|−|°|²|³|½|¼|∂|∇|Σ_/, "")
            gsub(/[!-,.\/:-@[\\\]^`{|}~]/, "")
            $0 = tolower($0)
            gsub(/Δ/, "δ"); gsub(/Φ/, "φ"); gsub(/Σ/, "σ"); gsub(/Ω/, "ω")
            gsub(/ /, "-")
            print seen[$0]++ ? $0 "-" (seen[$0] - 1) : $0
        }' "$1"
}

broken=0 count=0
for file in "${files[@]}"; do
    case $file in
        */*) folder=${file%/*} ;;
        *) folder=. ;;
    esac
    while read -r line target; do
        case $target in
            "" | [a-z]*:*) continue ;;
        esac
        count=$((count + 1))
        path=${target%%#*} anchor=
        [ "$path" = "$target" ] || anchor=${target#*#}
        path=${path//%20/ }
        if [ -z "$path" ]; then where=$file; else where=$folder/$path; fi
        if [ ! -e "$where" ]; then
            echo "$file:$line: $target: no such file"
            broken=$((broken + 1))
        elif [ -n "$anchor" ] && [ -f "$where" ]; then
            if [ -z "${known[$where]-}" ]; then
                known[$where]=yes
                while IFS= read -r name; do heading[$where#$name]=yes; done < <(anchors "$where")
            fi
            if [ -z "${heading[$where#$anchor]-}" ]; then
                echo "$file:$line: $target: no such heading"
                broken=$((broken + 1))
            fi
        fi
    done < <(links "$file")
done
while IFS=: read -r file line name; do
    echo "$file:$line: $name: no such source"
    broken=$((broken + 1))
done < <(awk '
    FNR == NR { path = $0; do is[path] = 1; while (sub(/^[^\/]*\//, "", path)); next }
    { line = $0
      while (match(line, /`[A-Za-z0-9_\/]+\.[ch]`/)) {
          name = substr(line, RSTART + 1, RLENGTH - 2)
          line = substr(line, RSTART + RLENGTH)
          if (!(name in is) && name !~ /[A-Z]/ && name !~ /^[a-z_]+_law\.c$/) print FILENAME ":" FNR ":" name
      } }' <(git ls-files '*.[ch]') "${files[@]}")
if [ "$broken" -gt 0 ]; then
    echo "$broken of $count links are broken"
    exit 1
fi
echo "$count links hold"
