#!/usr/bin/env bash
# bench/cans/run.sh with stand-ins for CaNS and frana: which numbers it reads, what it writes.    usage: cans.sh WORK
set -euo pipefail
run=$(cd "$(dirname "$0")/../../.." && pwd)/bench/cans/run.sh work=$1
rm -rf "$work" && mkdir -p "$work/built/run" "$work/silent" && cd "$work"
fail() { echo "FAILED: $*" >&2; exit 1; }

# Stand-in for CaNS: the input's steps, of 30 ms in the small flow, printed in the words of CaNS 4, and 400 ms in the
# large one, in the words before. The first steps and the last, with its checkpoint, take longer.
cat >built/run/cans <<'STOP'
#!/usr/bin/env bash
[ -d data ] && [ "${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-0}}" = 0 ] || exit 0
ulimit -s >"$SEEN/stack"
cp input.nml "$SEEN/input.$(sed -n 's/^ng(1:3) = \([0-9]*\),.*/\1/p' input.nml)"
awk '/^ng/ { ms = $3 == "128," ? 30 : 400 } /^nstep/ { n = $3 + 0 }
     END { for (k = 1; k <= n; k++) {
             t = (k <= 2 || k == n ? 5 : 1) * ms / 1000
             print " Time step #", k
             print (ms == 30 ? " Average, minimum & maximum" : " Avrg, min & max") " elapsed time: "
             printf "  %.16f  %.16f  %.16f\n", 0.9 * t, 0.8 * t, t } }' input.nml
STOP
# Stand-in for frana bench: a table with 5 and 80 ms.
cat >frana <<'END'
#!/usr/bin/env bash
while [ $# -gt 1 ]; do [ "$1" = --out ] && out=$2; shift; done
mkdir -p "$out"
printf 'part,size,ranks,median_ms\nfluid_step,32x16x16,2,1\nfluid_step,128x64x64,2,5\nchannel_step,256x128x128,2,80\n' \
  >"$out/machine-2.csv"
END
printf '#!/bin/sh\necho nothing\n' >silent/cans
chmod +x built/run/cans frana silent/cans
export SEEN=$PWD

"$run" --cans built --frana ./frana --ranks 2 --steps 12 --repeats 3 --out out >said
diff out/cans.csv - <<'END' || fail "another table"
code,part,size,ranks,theirs_ms,ours_ms,ratio,spread
CaNS,fluid_step,128x64x64,2,30,5,6.00,6.00-6.00
CaNS,channel_step,256x128x128,2,400,80,5.00,5.00-5.00
END
[ "$(cat stack)" = "$(ulimit -s unlimited 2>/dev/null || ulimit -s hard; ulimit -s)" ] || fail "the stack's limit"
grep -q '128x64x64, 2 ranks: CaNS 30 ms, frana 5 ms a step (medians of 3), ratio 6.00' said || fail "another sentence"
for line in "ng(1:3) = 128, 64, 64" "l(1:3) = 2, 1, 1" "nstep = 12," "is_forced(1:3) = F," "dims(1:2) = 1, 2" \
  "cbcvel(0:1,1:3,1) = 'D','N', 'D','D', 'P','P'" "cbcvel(0:1,1:3,2) = 'N','N', 'D','D', 'P','P'" \
  "cbcpre(0:1,1:3) = 'N','D', 'N','N', 'P','P'" "bcvel(0:1,1:3,1) = 1.,0., 0.,0., 0.,0."; do
  grep -qF "$line" input.128 || fail "the inflow's input lacks: $line"
done
for line in "ng(1:3) = 256, 128, 128" "is_forced(1:3) = T," "cbcvel(0:1,1:3,1) = 'P','P', 'D','D', 'P','P'" \
  "cbcpre(0:1,1:3) = 'P','P', 'N','N', 'P','P'"; do
  grep -qF "$line" input.256 || fail "the channel's input lacks: $line"
done
# refuses SENTENCE options...
refuses() {
  local sentence=$1 code=0
  shift
  "$run" "$@" >/dev/null 2>err || code=$?
  if [ $code != 2 ] || ! grep -qF -e "$sentence" err; then cat err >&2; fail "run.sh $*: code $code"; fi
}
refuses "has not printed the times of its steps" --cans silent --frana ./frana --repeats 1
refuses "there is no program cans" --cans out --frana ./frana
refuses "--cans DIR" --frana ./frana
refuses "there is no such program" --cans built --frana ./missing
refuses "--ranks 0: must be" --cans built --frana ./frana --ranks 0
refuses "unknown option" --can built
