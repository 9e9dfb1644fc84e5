#!/usr/bin/env bash
# Equations of the pages: good ones are typeset in the site, and the search shows their symbols; of each bad one the
# check and the build of the site name the place, and fail. Skipped where mkdocs' theme or KaTeX is missing.
#   equations.sh SOURCE WORK
# shellcheck disable=SC2016 # the dollars are those of equations
set -euo pipefail
source=$1 work=$2
node "$source/tools/site/equations.js" --style >/dev/null 2>&1 || exit 77
case $(mkdocs build --help 2>/dev/null || true) in *material*) ;; *) exit 77 ;; esac

rm -rf "$work"
mkdir -p "$work/docs"
cp -r "$source/tools" "$work/tools"
sed '/^nav:/,$d' "$source/mkdocs.yml" >"$work/mkdocs.yml"
cd "$work"
git init -q .

failed=0
fail() {
    echo "$1"
    failed=1
}
page() { printf '%s\n' "# A page" "" "$@" >docs/README.md; }

page 'The root $`\sqrt{x_1 x_2}`$ of ($`\rho_f`$), and code `$x` and ``$`x`$``.' '' \
    '```math' '\frac{a}{b} \lt \hat{u}^*' '```' '' \
    '| symbol | unit |' '|---|---|' '| $`\lvert \xi \rvert`$ | m |' '' \
    '* in a list' '' '    ```math' '    a = b' '    ```' '' \
    '~~~~' '```math' '\this is no equation' '```' '~~~~'
python3 tools/site/equations.py docs/README.md >log || fail "good equations are refused: $(cat log)"
grep -qx '5 equations are typeset' log || fail "of 5 equations: $(cat log)"
mkdocs build -q >log 2>&1 || fail "the site of good equations is not built: $(cat log)"
shown=$(grep -o 'class="katex"' build/site/index.html | wc -l || true)
[ "$shown" = 5 ] || fail "$shown equations of 5 are in the page"
grep -q '<annotation encoding="application/x-tex">\\sqrt{x_1 x_2}</annotation>' build/site/index.html ||
    fail "an underscore was read as Markdown"
grep -q '<link rel="stylesheet" href="assets/equations.css">' build/site/index.html ||
    fail "the page has no style sheet"
grep -qF '\u03c1f' build/site/search/search_index.json || fail "the search does not show the symbols of equations"
! grep -q 'sqrt\|frac' build/site/search/search_index.json || fail "the search's index holds LaTeX"
! grep -o 'url([^)]\{9\}' build/site/assets/equations.css | grep -v 'url(data:f' ||
    fail "a font is not in the style sheet"

# refused MESSAGE LINE...: a page of these lines, whose mistake is named by the check
refused() {
    local message=$1
    shift
    page "$@"
    ! python3 tools/site/equations.py docs/README.md >log 2>&1 || fail "the check accepts: $*"
    grep -q "^docs/README.md:[0-9]*: .*$message" log || fail "of $* the check says: $(cat log)"
}
# unbuilt MESSAGE LINE...: the same, and it ends the build
unbuilt() {
    refused "$@"
    ! mkdocs build -q >log 2>&1 || fail "the site is built of: $*"
    grep -q "docs/README.md:[0-9]*: .*$1" log || fail "of $* the build says: $(cat log)"
}
unbuilt 'KaTeX parse error' 'A fraction $`\frac{a}`$.'
unbuilt 'Undefined control sequence: .fra' '```math' '\fra{a}{b}' '```'
refused 'GitHub has no .operatorname' 'The trace $`\operatorname{tr} A`$.'
refused 'write .lt' 'Where $`a < b`$.'
refused 'ends a cell' '| | |' '|---|---|' '| $`|a|`$ | m |'
refused 'touches the equation' 'The n$`x`$.'
refused 'not written as' 'The old way $x_1$.'
refused 'not written as' '$$ x $$'
refused 'in a heading' '## About $`x`$'
exit $failed
