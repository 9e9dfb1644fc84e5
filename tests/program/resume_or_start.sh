#!/usr/bin/env bash
# --resume-or-start: one command that starts a run, goes on with it, and does nothing once it is done.
# usage: resume_or_start.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cat >scene.yaml <<'YAML'
title: A short bar, pulled
domain: {size: [0.016, 0.004, 0.004]}
solid:
  spacing: 1.0e-3
  materials: [{name: any, youngs_modulus: 1.0e8, density: 3000}]
  bodies: [{name: bar, shape: box, low: [0, 0, 0], high: [0.016, 0.004, 0.004]}]
  constraints: [{low: [0, 0, 0], high: [0.003, 0.004, 0.004], directions: xyz}]
  loads: [{low: [0.013, 0, 0], high: [0.016, 0.004, 0.004], force: [1.0e6, 0, 0]}]
stages: [{name: pull, steps: 5, time_step: 1.0e-6}]
output: {series_every: 1, fields_every: 3, checkpoint_every: 0}
YAML
again() { ranks 1 run scene.yaml --resume-or-start "$@"; }
said() { grep -q -e "$1" "$2" || fail "not said: $1: $(cat out err)"; }
# files_of FOLDER: its files with their times, inodes and sizes
files_of() { find "$1" -type f -exec stat -c '%n %Y %i %s' {} + | sort; }

# the same command until it is done; every call but the last takes a step or two
code 0 ranks 1 run scene.yaml --out whole
calls=0 got=75
while [ $got = 75 ]; do
  got=0
  again --out often --max-wall 1e-9 >out 2>err || got=$?
  calls=$((calls + 1))
  [ $calls -le 10 ] || fail "does not end"
done
[ $got = 0 ] && [ $calls -ge 3 ] || fail "ended with $got after $calls calls: $(cat out err)"
same whole/series.csv often/series.csv
[ "$(ls whole/fields)" = "$(ls often/fields)" ] || fail "other fields: $(ls often/fields)"

# a run that is done: nothing is written; with more steps asked for it goes on
before=$(files_of often)
code 0 again --out often
said '^often: this run is done, nothing is left to do$' out
[ "$(files_of often)" = "$before" ] || fail "files of a run that is done have changed"
code 0 again --out often --set stages.pull.steps=7
said 'resumed at step 5' out
said '^the stages have changed since the checkpoint: stages\[0\].steps: 5, now 7$' often/run.log
! grep -q 'the scene has changed' often/run.log || fail "the scene has not changed: $(cat often/run.log)"
[ "$(tail -n 1 often/series.csv | cut -d, -f1)" = 7 ] || fail "more steps"

# killed before its first checkpoint: refused to another scene; starts anew, and its files are kept
rows() { # the run of this number is at work: the files of the one before are moved
  { [ "$1" = 1 ] || [ -e killed/unfinished_1/series.csv ]; } &&
    [ "$(cat killed/series.csv 2>/dev/null | wc -l)" -gt 9 ]
}
long="--set stages.pull.steps=100000000"
for n in 1 2; do
  # shellcheck disable=SC2086 # words
  "$frana" run scene.yaml --out killed $long --resume-or-start >first 2>&1 & pid=$!
  await $pid rows $n || fail "has ended: $(cat first)"
  # shellcheck disable=SC2086
  code 4 again --out killed $long
  said 'another run is at work there' err
  kill -9 $pid
  wait $pid 2>/dev/null || true
  [ -z "$(ls killed/checkpoint)" ] || fail "a checkpoint was made"
  kept=$(cat killed/series.csv killed/fields/solid_00000003.hdf | cksum)
  code 4 again --out killed
  said 'holds a run of another scene, without a checkpoint' err
  if [ $n = 1 ]; then continue; fi
  # shellcheck disable=SC2086
  code 75 again --out killed $long --max-wall 1e-9
  said 'had not reached a checkpoint: its files are in killed/unfinished_2' killed/run.log
  [ "$(cat killed/unfinished_2/series.csv killed/unfinished_2/fields/solid_00000003.hdf | cksum)" = "$kept" ] ||
    fail "a finished file is lost or changed"
  [ -s killed/unfinished_1/series.csv ] && [ -s killed/unfinished_1/run.log ] || fail "the first killed run's files"
  [ "$(tail -n 1 killed/series.csv | cut -d, -f1)" -lt 9 ] || fail "has not begun anew"
done

# ended while it opened its tables: starts anew
mkdir ended && ln -s nowhere ended/reactions.csv
code 4 again --out ended
[ -e ended/series.csv ] || fail "no table was opened"
rm ended/reactions.csv
code 0 again --out ended
said 'had not reached a checkpoint: its files are in ended/unfinished_1' ended/run.log

# a folder of other files, a file, a scene with a mistake: refused, and nothing is written
mkdir mine && echo notes >mine/notes
code 4 again --out mine
said 'mine holds other files and no run' err
[ "$(ls mine)" = notes ] || fail "something was written: $(ls mine)"
code 4 again --out scene.yaml
# shellcheck disable=SC2086
code 2 again --out killed $long --set stages.pull.time_step=-1
[ ! -e killed/unfinished_3 ] || fail "moved away for a scene with a mistake"
code 2 again --out often --resume
said 'does not go with --resume' err
mkdir empty
code 0 ranks 2 run scene.yaml --resume-or-start --out empty
same whole/series.csv empty/series.csv

# a scene that is solved at once
once=$source/tests/scene/scenes/nonlocal.yaml
code 0 ranks 1 run "$once" --resume-or-start --out solved
rm solved/run.json
code 0 ranks 1 run "$once" --resume-or-start --out solved
said 'its files are in solved/unfinished_1' solved/run.log
[ -s solved/unfinished_1/solution.csv ] || fail "the first solution is lost"
code 0 ranks 1 run "$once" --resume-or-start --out solved
said 'this run is done' out
# tables whose rows up to the checkpoint are not those that were written are refused, before a file is changed
with=(--set 'output.probes={every: 1, at: [[0.008, 0.002, 0.002], [0.009, 0.002, 0.002]]}' --set output.reactions=true)
code 75 again --out table "${with[@]}" --max-wall 1e-9
code 0 ranks 1 run scene.yaml --out table --resume "${with[@]}" --set output.checkpoint_every=3 --set stages.0.steps=9
tables=$(cd table && ls ./*.csv | cut -c 3-)
[ "$(tr '\n' ' ' <<<"$tables")" = "probes.csv reactions.csv series.csv " ] || fail "other tables: $tables"
torn() { # TABLE REGEX COMMAND...: the command changes torn/TABLE, and the run is refused with this sentence
  local table=$1 said=$2 before
  rm -rf torn && cp -r table torn
  shift 2
  "$@"
  before=$(files_of torn/fields; cat torn/*.csv 2>/dev/null || true)
  code 4 ranks 1 run scene.yaml --out torn --resume "${with[@]}" --set stages.0.steps=12
  grep -Eq "torn/$table: $said" err || fail "$table, $*: $(cat err)"
  [ "$(files_of torn/fields; cat torn/*.csv 2>/dev/null || true)" = "$before" ] || fail "$table, $*: files have changed"
}
in_its_place() { rm "$1" && mkdir "$1"; }
by_day_once() { [ "$1" = probes.csv ] || thorough; } # one sentence serves all tables
for table in $tables; do
  torn $table 'has [0-9]+ rows up to step 9, and [0-9]+ were written' sed -i 4d torn/$table
  by_day_once $table || continue
  torn $table 'has [0-9]+ rows up to step 9, and [0-9]+ were written' sed -i '$d' torn/$table
  torn $table 'has other rows up to step 9' sed -i 4p torn/$table
  torn $table 'has other rows up to step 9' sed -i '4{h;d};5{G}' torn/$table
  torn $table 'has other rows up to step 9' sed -i '4s/[1-9]$/0/;4t;4s/$/0/' torn/$table
  torn $table 'cannot be continued: a row has not as many numbers' sed -i '4s/,[^,]*$//' torn/$table
  torn $table 'cannot be continued: it has no row of names' sed -i 1d torn/$table
  torn $table 'cannot be continued: it has no row of names' truncate -s 0 torn/$table
  torn $table 'cannot be continued: Is a directory' in_its_place torn/$table
done
rm -rf torn && cp -r table torn && rm torn/series.csv # a new one begins, and is looked at from then on
tail -n 1 table/probes.csv >>torn/probes.csv # behind all that were written
code 0 ranks 2 run scene.yaml --out torn --resume "${with[@]}" --set stages.0.steps=12
cmp <(head -n "$(wc -l <table/probes.csv)" torn/probes.csv) table/probes.csv || fail "a row stays twice"
grep -q '^torn/series.csv is not there: it begins after step 9$' torn/run.log ||
  fail "a lost table, and the log says nothing"
code 0 ranks 1 run scene.yaml --out torn --resume "${with[@]}" --set stages.0.steps=15 \
  --set solid.materials.0.density=2999
said '^warning: the scene has changed since the checkpoint: solid.materials\[0\].density: 3000, now 2999$' torn/run.log
[ "$(grep -vc '^[#s]' torn/series.csv)" = 6 ] || fail "$(cat torn/series.csv)"
echo ok
