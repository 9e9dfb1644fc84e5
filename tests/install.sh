#!/usr/bin/env bash
# The installed tree, moved to another place, is whole: the program runs a scene that was installed with it, on two
# ranks, each command has a manual page, and its module loads where there are modules.
# usage: install.sh FRANA SOURCE WORK BUILD
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/program/common.sh" "$@"
cmake --install "$4" --prefix "$PWD/made" >install.log || { cat install.log; fail "cmake --install"; }
mv made moved
frana=$PWD/moved/bin/frana
code 0 ranks 1 --version
code 0 ranks 1 --help
commands=$(sed -n 's/^  frana \([a-z][a-z_]*\).*/\1/p' out | sort -u)
[ "$(wc -l <<<"$commands")" -ge 7 ] || fail "the commands are: $commands"

set -- moved/share/man/man1/frana*.1
[ $# = $((1 + $(wc -l <<<"$commands"))) ] || fail "pages: $*; commands: $commands"
for command in $commands; do
  page=moved/share/man/man1/frana-$command.1
  { grep -q "^\.SH SYNOPSIS" "$page" && grep -Eq "^\.B frana $command( |$)" "$page"; } || fail "$page: no synopsis"
  grep -q "frana $command" moved/share/man/man1/frana.1 || fail "frana.1 lacks $command"
done
# an option of the program, and an exit code of base/die.h
grep -q -- 'max\\-wall' moved/share/man/man1/frana-run.1 || fail "frana-run.1 lacks --max-wall"
grep -A 1 '^\.B 75' moved/share/man/man1/frana.1 | grep -q checkpoint || fail "frana.1 lacks exit code 75"
if command -v man >/dev/null; then
  for page in "$@"; do
    said=$(LC_ALL=C.UTF-8 man --warnings -E UTF-8 -l "$page" 2>&1 >/dev/null) || true
    [ -z "$said" ] || fail "$page: $said"
  done
fi

scene=moved/share/frana/cases/channel/scene.yaml
code 0 ranks 1 check $scene
code 0 ranks 2 run $scene --out run --set stages.develop.steps=20 --set output.fields_every=20
grep -q '"status": *"done"' run/run.json || fail "the run is not done"
[ -f moved/share/doc/frana/docs/scene.md ] || fail "no documentation"
if [ -d "$source/tools/completion" ]; then
  bash -n moved/share/bash-completion/completions/frana || fail "no completion"
fi
# the scenes of frana init are found beside the program
if grep -qx init <<<"$commands"; then
  [ -f moved/share/frana/examples/channel.yaml ] || fail "no scene for frana init"
  code 0 ranks 1 init channel copied
fi
# the module finds the moved tree from its own place
version=$("$frana" --version | sed -n '1s/^frana \([0-9.]*\).*/\1/p')
for file in "$version" "$version.lua"; do
  [ -f "moved/share/modulefiles/frana/$file" ] || fail "no module file $file"
done
for init in "${LMOD_PKG:-/usr/share/lmod/lmod}/init/bash" "${MODULESHOME:-/usr/share/modules}/init/bash"; do
  [ -f "$init" ] || { echo "not tried: no $init"; continue; }
  (
    set +eu # as the shell of a user
    . "$init"
    module use "$PWD/moved/share/modulefiles" && module load frana || fail "$init: module load frana"
    [ "$(command -v frana)" = "$frana" ] || fail "$init: the module's frana is $(command -v frana), not $frana"
    frana --version >module_version || fail "$init: frana --version"
    grep -q "^frana $version" module_version || fail "$init: the module's frana is $(cat module_version)"
    [ "$FRANA_ROOT" = "$PWD/moved" ] || fail "$init: FRANA_ROOT is $FRANA_ROOT"
    module unload frana
    [ -z "$FRANA_ROOT" ] || fail "$init: FRANA_ROOT is $FRANA_ROOT after module unload"
  ) 2>module_log || { cat module_log >&2; exit 1; }
done
echo ok
