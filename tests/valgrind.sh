#!/usr/bin/env bash
# The small version of the main case, one cavity's period wide, under valgrind's memcheck on one rank: a few steps of
# each stage while bonds break, a resumed run, and frana post. Tests that there is no invalid access or free, no use of
# uninitialised values and no memory leak with frana's own code on the stack.
# usage: tests/valgrind.sh FRANA SOURCE WORK
# FRANA may use AVX-512, which valgrind does not know: another program is built in WORK/build. Exit code 77 without
# valgrind.
command -v valgrind >/dev/null || { echo "skipped: there is no valgrind here"; exit 77; }
build=$(realpath -m "$3")/build
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/program/common.sh" "$1" "$2" "$3/run"
export OMPI_MCA_btl=self
export XDG_CACHE_HOME=$PWD/cache # so that times measured under valgrind do not plan other runs

arch=
[ "$(uname -m)" != x86_64 ] || arch=x86-64-v3
generator=()
[ -f "$build/CMakeCache.txt" ] || ! command -v ninja >/dev/null || generator=(-G Ninja)
code 0 cmake -S "$source" -B "$build" "${generator[@]}" -DFRANA_ARCH=$arch -DCMAKE_BUILD_TYPE=RelWithDebInfo
code 0 cmake --build "$build" --parallel "$(getconf _NPROCESSORS_ONLN)" --target frana
frana=$build/frana

suppressions=(--suppressions="$source/tests/valgrind.supp")
for file in /usr/share/openmpi/openmpi-valgrind.supp /usr/lib/*/openmpi/share/openmpi/openmpi-valgrind.supp; do
  [ ! -f "$file" ] || suppressions+=(--suppressions="$file")
done
# memcheck NAME COMMAND...: valgrind's messages go to NAME.log
memcheck() {
  local name=$1
  shift
  code 0 valgrind --log-file="$name.log" --leak-check=full --show-leak-kinds=definite --num-callers=40 \
    --fullpath-after= "${suppressions[@]}" "$@"
  grep -q 'ERROR SUMMARY' "$name.log" || fail "$name.log has no end"
}
# findings NAME ROOT: number of errors with a frame in a file below ROOT, other than main
findings() {
  sed -E 's/^==[0-9]+== ?//' "$1.log" | awk -v root="($2/" '
    function close_block() { if (ours && error) { printf "%s\n", block; found++ } block = ""; ours = error = 0 }
    /^$/ { close_block(); next }
    { block = block $0 "\n" }
    /^(Invalid|Mismatched|Conditional jump|Use of uninit|Syscall param|Source and destination)/ { error = 1 }
    /^Process terminating|definitely lost in/ { error = 1 }
    /^ +(at|by) 0x/ && index($0, root) && !/: main \(/ { ours = 1 }
    END { close_block(); exit (found > 0) }'
}

# tests that such errors would be found
mkdir errs
cat >errs/errs.c <<'END'
#include <stdlib.h>
static int sum(int n) {
    int *a = malloc(sizeof *a * n);
    if (a[0] > a[n]) return 1;
    return 0;
}
int main(void) { return 2 * sum(4) & 4; }
END
code 0 cc -g -O0 -o errs/errs "$PWD/errs/errs.c"
memcheck errs errs/errs
! findings errs "$PWD/errs" >errs/found || fail "valgrind finds nothing in a program that errs"
for what in 'Conditional jump' 'Invalid read' 'definitely lost'; do
  grep -q "$what" errs/found || fail "not found in a program that errs: $what"
done

few=(--set stages.flow.steps=2 --set stages.settle.steps=2 --set stages.fracture.steps=4 --set output.series_every=1
  --set output.fields_every=4 --set output.checkpoint_every=3 --set 'solid.materials[0].fracture_energy=1.0e-7')
scene >twin.yaml
memcheck run "$frana" run twin.yaml --out twin "${few[@]}"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "bonds_broken") b = i }
  END { exit !($b > 0) }' twin/series.csv ||
  fail "nothing has broken"
memcheck resume "$frana" run twin.yaml --out again --resume=twin/checkpoint/stage_settle.h5 "${few[@]}"
memcheck post "$frana" post again
for name in run resume post; do
  findings "$name" "$source" >found || { cat found >&2; fail "see $PWD/$name.log"; }
  echo "$name: nothing in frana's frames; $(sed -E 's/^==[0-9]+== //' "$name.log" | grep 'ERROR SUMMARY')"
done
echo ok
