#!/usr/bin/env bash
# Completion in bash offers commands, their options, cases, scenes, and the keys of --set; frana init writes scenes that
# pass frana check.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# shellcheck source=tools/completion/frana.bash
. "$source/tools/completion/frana.bash"
# offers LINE WORD...: these, in any order, are among what completes the line; offers_only: nothing else
complete_line() {
  COMP_LINE=$1 COMP_POINT=${#1}
  read -ra COMP_WORDS <<<"$COMP_LINE"
  COMP_WORDS[0]=$frana
  [[ $COMP_LINE != *' ' ]] || COMP_WORDS+=("")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _frana
}
offers() {
  local line=$1 word
  complete_line "$line"; shift
  for word in "$@"; do
    # no pipe: grep -q ends at the first match, and what is still written then would fail
    grep -qxF -- "$word" <<<"$(printf '%s\n' "${COMPREPLY[@]}")" ||
      fail "frana ${line#frana }: not $word but ${COMPREPLY[*]}"
  done
}
offers_only() {
  offers "$@"
  [ ${#COMPREPLY[@]} = $(($# - 1)) ] || fail "$1: also ${COMPREPLY[*]}"
}
touch mine.yaml other.yml notes.txt && mkdir folder
offers_only 'frana c' check calibrate
offers 'frana ' run check post study bench permeability calibrate init schema keys help --version
offers 'frana run --re' --resume
offers_only 'frana check --m' --measure
offers 'frana post --' --film --slice --level --magnify --out --help
offers_only 'frana init pl' plate_hole plate_wave
offers_only 'frana run m' mine.yaml
offers_only 'frana check ' mine.yaml other.yml folder/
offers_only 'frana run mine.yaml --set solid.sp' solid.spacing=
offers 'frana run mine.yaml --set stages[0].s' 'stages[0].steps=' 'stages[0].safety=' 'stages[0].solid='
offers_only 'frana run mine.yaml --set stages[0].fluid_integrator=' rk3
offers_only 'frana run mine.yaml --set output.events=t' true
offers_only 'frana keys domain.' domain.size domain.cells domain.periodic
offers_only 'frana help st' study

"$frana" init >list
mapfile -t names < <(sed -n 's/^  \([a-z0-9_]*\) .*/\1/p' list)
[ ${#names[@]} -ge 10 ] || fail "only ${#names[@]} cases"
for name in "${names[@]}"; do "$frana" init "$name" new >/dev/null; done
# without its comments a scene is that of the case, which tests/program/checks.sh checks
grep -v '^ *#' new/porous_channel.yaml >plain
grep -v '^ *#' "$source/cases/porous_channel/demo.yaml" | diff - plain || fail "frana init changes the scene"
grep -q '^  # cells: ' new/porous_channel.yaml || fail "no comment on domain.cells"
code 0 ranks 1 check new/bar.yaml
# an image of rock is made with its scene, and k is there at once
[ "$(stat --format %s new/rock.raw)" = 32768 ] || fail "no image of rock"
for n in 1 2; do code 0 ranks $n permeability new/rock.yaml --quick --out rock$n; done
[ "$(grep -c '^leads_.,1' rock1/permeability.csv)" = 3 ] || fail "no way through the rock"
mkdir kept && touch kept/rock.raw
code 2 ranks 1 init rock kept
grep -q 'rock.raw: is there already' err || fail "an image is overwritten"
[ ! -e kept/rock.yaml ] || fail "a scene without its image"
code 0 ranks 1 check new/notched_beam.yaml
! grep -n '](' new/*.yaml || fail "comments of frana init hold links of a page"
code 2 ranks 1 init bar new
grep -q 'is there already' err || fail "not said that the scene is there"
code 2 ranks 1 init bars
grep -q 'did you mean bar? frana init lists' err || fail "no nearest case: $(cat err)"
code 2 ranks 1 keys solid.spcing
grep -q 'no key begins so; frana keys lists all' err || fail "nothing said of a key that is not there: $(cat err)"
# each command explains itself
for command in $("$frana" help | sed -n 's/^  frana \([a-gi-z][a-z]*\).*/\1/p'); do
  "$frana" "$command" --help >out || fail "frana $command --help: exit code $?"
  "$frana" help "$command" | diff - out || fail "frana help $command and frana $command --help differ"
  grep -q "^usage: frana $command" out || fail "no usage of $command"
done
echo ok
