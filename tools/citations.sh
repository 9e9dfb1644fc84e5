#!/usr/bin/env bash
# Every short name that a source, page, script or scene cites must be in docs/sources.md: documents by number (001: eq.
# 3.71), papers by author and year (Breugem 2012), and equations that are cited as mended. Prints file:line of each that
# is not, and leaves with 1.
#   tools/citations.sh [FILE ...]
# shellcheck disable=SC2016 # awk in single quotes
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C
page=docs/sources.md

if [ $# -gt 0 ]; then
    printf '%s\0' "$@"
else
    git ls-files -z '*.c' '*.h' '*.md' '*.sh' '*.yaml' '*.awk' ':!:tests/fuzz/corpus' ':!:tests/scene/scenes'
fi | xargs -0 awk -v page="$page" '
    # names(LINE): the author and year of each paper in it, as "Breugem 2012", in found[1..]; returns how many. Of
    # several authors the first counts, and of a name with small words (ten Cate, van der Walt) the last word of it.
    function names(line,  n, text, author, year) {
        n = 0
        gsub(/[\047]s/, "", line) # Ha and Bobaru\047s (2010)
        gsub(/&/, "and", line)
        while (match(line, cited)) {
            text = substr(line, RSTART, RLENGTH)
            line = substr(line, RSTART + RLENGTH)
            author = text
            sub(/^[^A-Za-z\200-\377]+/, "", author)
            sub(/[ ,(].*/, "", author)
            year = text
            gsub(/[^0-9]/, "", year)
            if (year < 1800 || year > 2099) continue
            if (author ~ /^(Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec|Re|In|At|Of|The)$/) continue
            found[++n] = author " " year
        }
        return n
    }
    BEGIN {
        letter = "[A-Za-z\200-\377-]"
        name = "[A-Z\303]" letter letter "+"
        others = "(( et al[.])|((,| and) ([A-Z][.] )?(van )?(de )?(der )?" name ")*)"
        cited = name others "[ ,]+[(]?[12][0-9][0-9][0-9]([^0-9]|$)"
        document = "(^|[^0-9.,A-Za-z])00[0-9](: | *(eq|sec|ch|fig|tab|table|chapter)s?[. ]|\047s )"
        while ((getline line <page) > 0) {
            if (line !~ /^[|]/) continue
            split(line, cell, "|")
            n = names(cell[2])
            for (i = 1; i <= n; i++) {
                defined[found[i]] = 1
                year = found[i]
                sub(/.* /, "", year)
                m = split(cell[2], author, /[ ,]+/) # a comment may break after "Causin, Gerbeau and"
                for (k = 1; k <= m; k++) if (author[k] ~ "^" name "$") defined[author[k] " " year] = 1
            }
            if (cell[2] ~ /^ 00[0-9] $/) defined[substr(cell[2], 2, 3)] = 1
            if (cell[2] ~ /^ 00[0-9]: /) slips = slips cell[2] # "001: eq. 3.40"
        }
        close(page)
        if (!("001" in defined)) { print page ": no documents are defined there"; exit bad = 1 }
    }
    FILENAME == page { next }
    function miss(what) { printf "%s:%d: %s is not in %s\n", FILENAME, FNR, what, page; bad = 1 }
    {
        line = $0
        while (match(line, document)) {
            text = substr(line, RSTART, RLENGTH)
            line = substr(line, RSTART + RLENGTH - 1)
            sub(/^[^0]*/, "", text)
            if (!(substr(text, 1, 3) in defined)) miss("document " substr(text, 1, 3))
        }
        n = names($0)
        for (i = 1; i <= n; i++) if (!(found[i] in defined)) miss(found[i])
        line = $0
        while (match(line, /\([A-Z][A-Z][A-Z]+ [0-9]+(\.[0-9]+)*[,;)]/)) {
            miss(substr(line, RSTART + 1, RLENGTH - 2))
            line = substr(line, RSTART + RLENGTH)
        }
        # mended: the equations of the last document named before it, back to the semicolon or the document
        line = $0
        while ((at = index(line, "mended")) > 0) {
            text = substr(line, 1, at - 1)
            line = substr(line, at + 6)
            if (text !~ /00[0-9]: [^()]*$/) continue
            whose = text
            sub(/.*00/, "00", whose)
            whose = substr(whose, 1, 3)
            sub(/.*[;:]/, "", text)
            while (match(text, /[0-9]+(\.[0-9]+)?/)) {
                number = substr(text, RSTART, RLENGTH)
                before = substr(text, 1, RSTART - 1)
                text = substr(text, RSTART + RLENGTH)
                # of "eqs 3.20, 3.41 mended" the last alone is meant, of "3.47, 3.48, mended" all
                if (text ~ /^, [0-9]/ && text !~ /, $/) continue
                if (!has_slip(whose, number)) miss("mended " whose ": eq. " number)
            }
        }
    }
    function has_slip(whose, number,  part, n, i) {
        n = split(slips, part, " 00")
        for (i = 2; i <= n; i++)
            if ("00" substr(part[i], 1, 1) == whose && part[i] " " ~ " " escaped(number) "[ ,]") return 1
        return 0
    }
    function escaped(number) { gsub(/\./, "[.]", number); return number }
    END { exit bad }' || { echo "cite what $page defines, or define it there" >&2; exit 1; }
