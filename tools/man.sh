#!/usr/bin/env bash
# Writes the manual pages frana.1 and frana-COMMAND.1 into a folder, from what the program itself prints for --help and
# for COMMAND --help, and from the exit codes in base/die.h. The installation calls it.
#   tools/man.sh FRANA FOLDER
set -euo pipefail
frana=$(realpath "$1") folder=$2 source=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
mkdir -p "$folder"
rm -f "$folder"/frana*.1
usage=$("$frana" --help)
version=$("$frana" --version)
version=$(sed -n '/^frana /{p;q}' <<<"$version") # libraries may print as well

# roff: text for a page. "- " at the start of a line would be a list in no page, "." a request.
roff() { sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^[.']/\\\\\&&/"; }
# entries: of each command one line "synopsis TAB text". In the usage a command is indented by two, what follows by
# more; that is more of the synopsis if it begins with a bracket, else the text.
entries() {
    awk '
        function out() { if (synopsis) print synopsis "\t" text }
        /^  frana / { out(); synopsis = $0; text = ""; gsub(/^ +| +$/, "", synopsis); gsub(/  +/, " ", synopsis); next }
        /^    +/ && synopsis { gsub(/^ +/, ""); if (text == "" && /^\[/) synopsis = synopsis " " $0
                               else text = text (text == "" ? "" : " ") $0; next }
        { out(); synopsis = "" }
        END { out() }' <<<"$usage"
}
# page NAME WHAT: the head of a page
page() {
    printf '.TH %s 1 "" "%s" "frana"\n.SH NAME\n%s \\- %s\n' "${1^^}" "$version" "$(roff <<<"$1")" "$(roff <<<"$2")"
}
codes() {
    printf '.SH EXIT STATUS\n'
    sed -n 's|^ *EXIT_CODE_[A-Z]* = \([0-9]*\),* */\* \(.*\) \*/.*|\1\t\2|p' "$source/base/die.h" |
        { printf '0\tdone\n'; cat; } | while IFS=$'\t' read -r code why; do
        printf '.TP\n.B %s\n%s\n' "$code" "$(roff <<<"$why")"
    done
}
also() { printf '.SH SEE ALSO\n%s\n.PP\nThe pages of documentation, installed in share/doc/frana.\n' "$1"; }

names=()
while IFS=$'\t' read -r synopsis text; do
    name=$(awk '{ print $2 }' <<<"$synopsis")
    case $name in -*) continue ;; esac
    # two lines of usage may be of one command
    [[ " ${names[*]-} " == *" $name "* ]] || names+=("$name")
done < <(entries)

{
    page frana "fracture of solids in a flow"
    printf '.SH SYNOPSIS\n.B frana\n.I COMMAND\n[arguments] [options]\n.PP\n.B mpiexec \\-n\n.I N\n'
    printf '.B frana run\n.I SCENE.yaml\n.SH DESCRIPTION\n'
    printf 'frana computes how a solid breaks in a flow, by the incompressible Navier\\-Stokes equations in a channel\n'
    printf 'and bond\\-based peridynamics, coupled by an immersed boundary. A scene is a YAML file.\n.SH COMMANDS\n'
    entries | while IFS=$'\t' read -r synopsis text; do
        printf '.TP\n.B %s\n%s\n' "$(roff <<<"$synopsis")" "$(roff <<<"${text:-}")"
    done
    codes
    printf '.SH ENVIRONMENT\n.TP\n.B XDG_CACHE_HOME\n'
    printf 'frana/ in this folder (by default ~/.cache) keeps plans of transforms.\n'
    also "$(for name in "${names[@]}"; do printf '.BR frana\\-%s (1)\n' "$name"; done)"
} | sed '/^$/d' >"$folder/frana.1"

for name in "${names[@]}"; do
    if help=$("$frana" "$name" --help 2>/dev/null) && [ -n "$help" ]; then
        # "usage: ...", a paragraph, "options", and "  --option VALUE   text"
        what=$(awk 'NF == 0 { n++; next } n == 1 { text = text (text == "" ? "" : " ") $0 } n > 1 { exit }
            END { print text }' <<<"$help")
        short=$(sed -e 's/ *(docs[^)]*)//; s/\. .*//; s/\.$//' <<<"$what")
        page "frana-$name" "${short,}"
        printf '.SH SYNOPSIS\n'
        sed -n '/^usage: /,/^$/p' <<<"$help" | sed 's/^usage: *//; s/^ *//; /^$/d' | roff | sed 's/^/.B /; $!s/$/\n.br/'
        printf '.SH DESCRIPTION\n%s\n.SH OPTIONS\n' "$(roff <<<"$what")"
        sed '1,/^options/d' <<<"$help" | awk '
            /^  -/ { match($0, /^  [^ ]+( [^ ]+)?/); option = substr($0, 3, RLENGTH - 2)
                     rest = substr($0, RLENGTH + 1); sub(/^ +/, "", rest); print ".TP\n.B " option "\n" rest; next }
            { sub(/^ +/, ""); print }' | sed -e 's/\\/\\e/g' -e 's/-/\\-/g'
    else
        page "frana-$name" "command of frana"
        printf '.SH SYNOPSIS\n'
        entries | cut -f1 | awk -v n="$name" '$2 == n' | roff | sed 's/^/.B /; $!s/$/\n.br/'
        entries | awk -F'\t' -v n="$name" '{ split($1, word, " ") } word[2] == n && $2 { print ".SH DESCRIPTION\n" $2 }'
    fi | sed '/^$/d' >"$folder/frana-$name.1"
    {
        codes
        also '.BR frana (1)'
    } >>"$folder/frana-$name.1"
done
