#!/usr/bin/env bash
# Damaged checkpoints: one given by name is refused with exit code 4 and a sentence on the damage and on another, intact
# checkpoint. --resume without a name takes the intact one, reports that, and ends with the same series.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
scene >scene.yaml
code 0 ranks 2 run scene.yaml --out run --set output.checkpoint_every=50
newest=$(cat run/checkpoint/latest)
rm run/checkpoint/stage_fracture.h5 # it has the same state; the checkpoint before it is to be used
cp "run/checkpoint/$newest" good.h5
bytes=$(stat -c %s good.h5)
# the seal's list of arrays: name, position and size in bytes of each (base/files/seal.h)
python3 - good.h5 >arrays <<'END'
import struct, sys
seal = open(sys.argv[1], 'rb').read()[-2104:]
for k in range(struct.unpack_from('<Q', seal, 2048)[0]):
    name, at, size = struct.unpack_from('<32sQQ', seal, 64 * k)
    print(name.rstrip(b'\0').decode(), at, size)
END
[ "$(wc -l <arrays)" -ge 10 ] || { cat arrays; fail "fewer arrays than the state has"; }
# several N command...: by mpiexec for more than one rank
several() { if [ "$1" = 1 ]; then shift; "$frana" "$@"; else ranks "$@"; fi; }
invert_bit() { # FILE POSITION: of the byte
  local byte
  byte=$(od -An -tu1 -j "$2" -N 1 "$1")
  printf "\\x$(printf %02x $((byte ^ 16)))" | dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}
# named WHY [RANKS]: the newest checkpoint is given by name and refused; the message names an intact one
named() {
  code 4 several "${2:-1}" run scene.yaml --out none "--resume=run/checkpoint/$newest"
  grep -q "$1" err || { cat err; fail "not said: $1"; }
  grep -Eq -- '--resume=run/checkpoint/(step|stage)_[a-z0-9]*.h5 is whole' err || { cat err; fail "no other is named"; }
  [ "$(grep -c '^frana:' err)" = 1 ] || { cat err; fail "more than one sentence"; }
  rm -rf none
}
# passed_over WHY [RANKS]: --resume takes the one before, and the run ends with the same results
passed_over() {
  rm -rf on && cp -rp run on
  code 0 several "${2:-1}" run scene.yaml --out on --resume
  grep -q "^frana: passed over checkpoint on/checkpoint/$newest: .*$1" err ||
    { cat err; fail "not passed over for: $1"; }
  grep -q "^resumed from on/checkpoint/" on/run.log || fail "run.log does not say from where"
  same run/series.csv on/series.csv
}

# a bit of each array
while read -r -u 3 name at size; do
  cp good.h5 "run/checkpoint/$newest"
  invert_bit "run/checkpoint/$newest" $((at + size / 2))
  named "its array $name is damaged"
done 3<arrays
read -r name at size < <(tail -n 1 arrays)
named "its array $name is damaged" 3 # the last array, on other ranks
passed_over "its array $name is damaged" 2
# the one that the message names can be resumed
named "its array $name is damaged"
code 0 ranks 2 run scene.yaml --out branch "$(grep -o -- '--resume=[^ ]*h5' err)"
# a bit anywhere in the file
RANDOM=4711
for _ in $(seq 8); do
  cp good.h5 "run/checkpoint/$newest"
  invert_bit "run/checkpoint/$newest" $(((RANDOM * 32768 + RANDOM) % bytes))
  named 'damaged\|it is not an HDF5 file\|it has no seal'
done

# headers; files truncated at many positions; and the format before seals
cp good.h5 "run/checkpoint/$newest"
invert_bit "run/checkpoint/$newest" 100
named 'is damaged: its headers'
passed_over 'is damaged: its headers'
for size in 1 8 100 2000 20000 $((bytes / 2)) $((bytes - 2104 - 1)) $((bytes - 2103)) $((bytes - 8)) $((bytes - 1)); do
  head -c "$size" good.h5 >"run/checkpoint/$newest"
  named 'truncated or damaged\|it is not an HDF5 file'
done
passed_over 'truncated or damaged'
head -c -2104 good.h5 >"run/checkpoint/$newest"
named 'earlier version of frana' 2
# other objects of that name: none, a text, another HDF5 file, a folder
: >"run/checkpoint/$newest"
named 'it is not an HDF5 file'
passed_over 'it is not an HDF5 file'
echo rubbish >"run/checkpoint/$newest"
named 'it is not an HDF5 file'
cp "$(ls run/fields/fluid_*.hdf | tail -n 1)" "run/checkpoint/$newest"
named 'it has no seal: it is not a checkpoint'
rm "run/checkpoint/$newest" && mkdir "run/checkpoint/$newest"
named 'it is not a file'
rmdir "run/checkpoint/$newest"
named 'No such file or directory'

# `latest` names no file, is empty, is missing, is a folder: the checkpoints are found
cp good.h5 "run/checkpoint/$newest"
for latest in 'nothing.h5' '' gone folder; do
  rm -rf on && cp -rp run on
  rm on/checkpoint/latest
  case $latest in gone) ;; folder) mkdir on/checkpoint/latest ;; *) echo "$latest" >on/checkpoint/latest ;; esac
  if [ "$latest" = folder ]; then # then no new one can be written
    code 4 several 1 run scene.yaml --out on --resume --set stages.fracture.steps=61
    grep -q 'latest: cannot be written' err || { cat err; fail "a folder for latest"; }
    continue
  fi
  code 0 several 1 run scene.yaml --out on --resume
  grep -q "^resumed from on/checkpoint/$newest" on/run.log ||
    { cat on/run.log; fail "latest = $latest: another is taken"; }
done

# no checkpoint is intact
rm -rf on && cp -rp run on
for file in on/checkpoint/*.h5; do invert_bit "$file" 3000; done
code 4 several 1 run scene.yaml --out on --resume
grep -q 'is damaged' err || { cat err; fail "no checkpoint is whole"; }
# a checkpoint of another scene
code 5 several 1 run scene.yaml --out none "--resume=run/checkpoint/$newest" --set solid.materials.0.horizon_ratio=2
grep -q 'began with other bonds than the scene' err || { cat err; fail "another horizon"; }
code 5 several 1 run scene.yaml --out none "--resume=run/checkpoint/$newest" --set stages.fracture.name=crack
grep -q 'was written in stage fracture, which the scene does not have' err || { cat err; fail "another stage"; }
code 5 several 1 run scene.yaml --out none "--resume=run/checkpoint/$newest" \
  --set 'solid.unbreakable=[{low: [0, 0, 0], high: [1, 1, 1]}]'
grep -q 'other unbreakable particles than the scene' err || { cat err; fail "other unbreakable particles"; }
code 0 ranks 2 run scene.yaml --out changed "--resume=run/checkpoint/$newest" --set solid.materials.0.fracture_energy=1
code 5 ranks 2 run scene.yaml --out none "--resume=run/checkpoint/$newest" --set solid.spacing=0.003125
grep -q 'has particles .* m apart, the scene 0.003125 m' err || { cat err; fail "another spacing"; }
echo ok
