#!/usr/bin/env bash
# Runs the commands of a tutorial in an empty folder, and compares what the page shows with what they print.
# usage: run.sh FRANA PAGE.md FOLDER
#
# In the page
#   <!-- file: NAME -->     before a fenced block: the block is the file NAME
#   ```sh                   commands, which must succeed
#   ```text                 lines that the commands before it print, in this order; other lines may stand between them.
#                           Numbers may differ by 1 %, and what follows … in a line is not compared
# A script beside this one that has the page's name looks at the files afterwards: it is called in their folder, and
# ../all has what all commands printed.
set -euo pipefail
frana=$(realpath "$1") page=$(realpath "$2") folder=$3
check=$(realpath "$(dirname "$0")")/$(basename "$page" .md).sh
export LC_ALL=C.UTF-8
rm -rf "$folder"
mkdir -p "$folder/work" "$folder/blocks"
cd "$folder/work"
PATH=$(dirname "$frana"):$PATH

# The blocks in their order: blocks/001.sh, blocks/002.text, ...; list has a line a block: its file, its kind, its name
awk -v to=../blocks '
    /^<!-- file: .* -->$/ { name = $3; next }
    /^```/ && !open {
        open = 1
        kind = name ? "file" : substr($0, 4)
        path = sprintf("%s/%03d.%s", to, ++n, kind)
        print path, kind, name > (to "/list")
        printf "" > path
        next
    }
    /^```$/ { open = 0; name = ""; close(path); next }
    open { print > path }' "$page"

ran=0 shown=0
while read -r path kind name; do
  case $kind in
    file) cp "$path" "$name" ;;
    sh)
      ran=$((ran + 1))
      bash -euo pipefail "$path" >../printed 2>&1 </dev/null || {
        cat "$path" ../printed
        echo "a command of $page fails"
        exit 1
      }
      cat ../printed >>../all ;;
    text)
      shown=$((shown + 1))
      awk -v page="$page" '
        function is_number(s) { return s ~ /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$/ }
        function near(a, b,  d, m) { d = a - b; m = b; return (d < 0 ? -d : d) <= 0.01 * (m < 0 ? -m : m) }
        # the words of a line; brackets, commas and colons are words of their own
        function words(line, w) { gsub(/[][(),:;]/, " & ", line); return split(line, w) }
        function same(line, shown,  a, b, n, k) {
            n = words(shown, b)
            k = words(line, a)
            for (k++; k <= n; k++) a[k] = ""
            for (k = 1; k <= n; k++) {
                if (b[k] == "…") return 1
                if (a[k] == b[k]) continue
                if (!is_number(a[k]) || !is_number(b[k]) || !near(a[k] + 0, b[k] + 0)) return 0
            }
            return words(line, a) == n
        }
        FNR == NR { printed[++n] = $0; next }
        NF == 0 || $0 ~ /^ *…$/ { next }
        { for (at++; at <= n && !same(printed[at], $0); at++) continue
          if (at > n) { print page ": this line is shown and not printed:"; print; exit 1 } }' ../printed "$path" || {
        echo "printed:"
        cat ../printed
        exit 1
      } ;;
  esac
done <../blocks/list
if [ -f "$check" ]; then
  bash -euo pipefail "$check"
elif [ "$shown" = 0 ]; then
  echo "$page: nothing is shown"
  exit 1
fi
if [ "$ran" = 0 ]; then
  echo "$page: no commands"
  exit 1
fi
echo "$page: $ran blocks of commands ran, $shown blocks of output are as shown"
