# shellcheck shell=bash
# Completion of frana for bash: commands, options, cases, files, and the keys of --set.
# `source tools/completion/frana.bash`, or install it as share/bash-completion/completions/frana.

# Lines of the program's own lists. The program is the command that is being completed.
_frana_list() {
    case $2 in
    commands) "$1" help 2>/dev/null | sed -n 's/^  frana \([a-z-]*\).*/\1/p' ;;
    options) "$1" help "$3" 2>/dev/null | sed -n 's/^  \(--[a-z-]*\)[[ ].*/\1/p' ;;
    cases) "$1" init 2>/dev/null | sed -n 's/^  \([a-z0-9_]*\) .*/\1/p' ;;
    # a list's first entry stands for all, x_low for all sides; sections have no value
    keys) "$1" keys 2>/dev/null | awk -F '\t' '$2 != "section" && $2 != "list" {
            gsub(/\[\]/, "[0]", $1); sub(/SIDE/, "x_low", $1); print $1 "=" }' ;;
    # the values of a choice: words of the schema
    values) "$1" keys "$3" 2>/dev/null | awk -F '\t' -v key="$3" '$1 == key && $2 == "bool" { print "true"; print "false" }
            $1 == key && $3 != "needed" && $3 != "none" { print $3 }' ;;
    esac
}

_frana() {
    local program=${COMP_WORDS[0]} line word before command
    # --set, = and the brackets of a key may be words of their own: look at the line up to the cursor instead
    line=${COMP_LINE:0:COMP_POINT}
    word=${line##*[[:space:]]}
    before=${line%"$word"}
    before=${before%"${before##*[![:space:]]}"}
    before=${before##*[[:space:]]}
    command=${COMP_WORDS[1]}
    COMPREPLY=()
    if [ "$COMP_CWORD" = 1 ]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_frana_list "$program" commands)" -- "$word")
        return
    fi
    case $before in
    --set)
        local key=${word%%=*}
        if [ "$key" != "$word" ]; then
            key=${key//\[[0-9]\]/[]}
            mapfile -t COMPREPLY < <(compgen -W "$(_frana_list "$program" values "$key")" -- "${word#*=}")
            return
        fi
        mapfile -t COMPREPLY < <(_frana_list "$program" keys | awk -v begin="$word" 'index($0, begin) == 1')
        compopt -o nospace 2>/dev/null || :
        # bash replaces what follows the last character of COMP_WORDBREAKS
        local cut=${word%"${word##*[=:]}"} k
        for k in "${!COMPREPLY[@]}"; do COMPREPLY[k]=${COMPREPLY[k]#"$cut"}; done
        return
        ;;
    --out) mapfile -t COMPREPLY < <(compgen -d -- "$word") && return ;;
    esac
    if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_frana_list "$program" options "$command")" -- "$word")
        return
    fi
    case $command in
    help) mapfile -t COMPREPLY < <(compgen -W "$(_frana_list "$program" commands)" -- "$word") ;;
    init)
        if [ "$COMP_CWORD" = 2 ]; then
            mapfile -t COMPREPLY < <(compgen -W "$(_frana_list "$program" cases)" -- "$word")
        else
            mapfile -t COMPREPLY < <(compgen -d -- "$word")
        fi
        ;;
    keys) mapfile -t COMPREPLY < <("$program" keys "$word" 2>/dev/null | cut -f 1) ;;
    post) mapfile -t COMPREPLY < <(compgen -d -- "$word") ;;
    run | check | permeability | calibrate | study) # scenes, and folders on the way to them
        mapfile -t COMPREPLY < <(compgen -f -X '!*.y*ml' -- "$word"; compgen -d -S / -- "$word")
        [[ ${#COMPREPLY[@]} != 1 || ${COMPREPLY[0]} != */ ]] || compopt -o nospace 2>/dev/null || :
        ;;
    bench) mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
    esac
}
complete -F _frana frana
