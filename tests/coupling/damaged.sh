#!/usr/bin/env bash
# Checkpoints that are not as they were written: each is refused with exit code 4 and a sentence that names what is damaged and
# a checkpoint that is whole.
. "$(dirname "$0")/common.sh" "$@"
scene >scene.yaml
code 0 ranks 2 run scene.yaml --out run --set output.checkpoint_every=50
newest=$(cat run/checkpoint/latest)
cp "run/checkpoint/$newest" good.h5
# the seal's list of arrays: name, place and bytes of each (base/seal.h)
python3 - good.h5 >arrays <<'END'
import struct, sys
seal = open(sys.argv[1], 'rb').read()[-2104:]
for k in range(struct.unpack_from('<Q', seal, 2048)[0]):
    name, at, size = struct.unpack_from('<32sQQ', seal, 64 * k)
    print(name.rstrip(b'\0').decode(), at, size)
END
[ "$(wc -l <arrays)" -ge 10 ] || { cat arrays; fail "fewer arrays than the state has"; }
turn() { # FILE PLACE: turns a bit over
  local byte
  byte=$(od -An -tu1 -j "$2" -N 1 "$1")
  printf "\\x$(printf %02x $((byte ^ 16)))" | dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}
while read -r name at size; do
  cp good.h5 "run/checkpoint/$newest"
  turn "run/checkpoint/$newest" $((at + size / 2))
  code 4 "$frana" run scene.yaml --out run --resume
  grep -q "its array $name is damaged" err || { cat err; fail "$name is not named"; }
  grep -Eq -- '--resume=run/checkpoint/(step|stage)_[a-z0-9]*.h5 is whole' err || { cat err; fail "no other is named"; }
done <arrays
read -r name at size < <(tail -n 1 arrays)
code 4 ranks 3 run scene.yaml --out run --resume # the last array, on other ranks
grep -q "its array $name is damaged" err || { cat err; fail "$name is not named by three ranks"; }
[ "$(grep -c '^frana:' err)" = 1 ] || { cat err; fail "more than one sentence"; }
# the one that is named can be gone on from
other=$(grep -o 'resume=.*h5' err)
code 0 ranks 2 run scene.yaml --out on "--$other"

# headers: passed over where there is another
cp good.h5 "run/checkpoint/$newest"
turn "run/checkpoint/$newest" 100
code 4 ranks 1 run scene.yaml --out none "--resume=run/checkpoint/$newest"
grep -q 'is damaged: its headers' err && grep -q 'is whole' err || { cat err; fail "damaged headers"; }
code 0 ranks 1 run scene.yaml --out run --resume
grep -q 'passed over checkpoint' err || { cat err; fail "it does not say that one is passed over"; }
# cut short, and as written before there were seals
head -c 20000 good.h5 >"run/checkpoint/$newest"
code 4 ranks 1 run scene.yaml --out none "--resume=run/checkpoint/$newest"
grep -q 'truncated or damaged' err && grep -q 'is whole' err || { cat err; fail "a file cut short"; }
head -c -2104 good.h5 >"run/checkpoint/$newest"
code 4 ranks 2 run scene.yaml --out none "--resume=run/checkpoint/$newest"
grep -q 'earlier version of frana' err || { cat err; fail "an older file"; }
# another scene's
cp good.h5 "run/checkpoint/$newest"
code 5 ranks 1 run scene.yaml --out none "--resume=run/checkpoint/$newest" --set solid.materials.0.horizon_ratio=2
grep -q 'bonds is of size' err || { cat err; fail "another horizon"; }
echo ok
