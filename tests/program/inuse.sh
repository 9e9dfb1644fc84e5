#!/usr/bin/env bash
# A run folder that another run holds is refused to every command that writes; commands that read may use it; after a
# kill it is free.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
scene | sed 's/fields_every: .*/fields_every: 0/; s/checkpoint_every: .*/checkpoint_every: 10/' >scene.yaml
mpiexec -n 2 "$frana" run scene.yaml --out run --set stages.flow.steps=1000000 >first 2>&1 & mpiexec=$!
trap 'kill -9 $mpiexec 2>/dev/null || true' EXIT
await $mpiexec test -f run/checkpoint/latest || { cat first; fail "the first run does not begin"; }

refused() {
  grep -Eq '^frana: run folder run: another run is at work there \(process [0-9]+ on .+\)$' err ||
    { cat err; fail "$*: no sentence"; }
  [ "$(grep -c '^frana:' err)" = 1 ] || { cat err; fail "$*: more than one sentence"; }
}
before=$(cat run/checkpoint/latest)
code 4 ranks 1 run scene.yaml --out run --resume && refused "a resume"
code 4 ranks 2 run scene.yaml --out ./run/../run --resume && grep -q 'another run is at work' err ||
  fail "by another name"
code 4 ranks 1 run scene.yaml --out run # a new run: existing files are not overwritten
grep -q 'holds a run already' err || { cat err; fail "a new run"; }
code 0 ranks 1 post run
[ -d run/post ] || fail "nothing was drawn of a run at work"
changed() { [ "$(cat run/checkpoint/latest)" != "$before" ]; }
await $mpiexec changed || fail "the first run has stopped"

# a killed run releases the folder when its last rank has ended
kill -9 "$mpiexec"
wait "$mpiexec" 2>/dev/null || true
while :; do
  got=0
  ranks 2 run scene.yaml --out run --resume --set stages.flow.steps=1000000 --max-wall 2 >out 2>err || got=$?
  { [ "$got" = 4 ] && grep -q 'another run is at work' err; } || break
  sleep 0.1
done
[ "$got" = 75 ] || { cat out err; fail "exit code $got after the first run was killed"; }
[ ! -e run/run.lock ] || fail "run.lock is left by a run that has ended"
echo ok
