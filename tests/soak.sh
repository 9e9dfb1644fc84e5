#!/usr/bin/env bash
# A coupled run that continues for a long time while its solid breaks and its fragments leave. Its memory must not grow,
# and conserved quantities must not drift. A porous block in a stream is pushed to and fro, each time harder, so that
# bonds break until the end.
# usage: tests/soak.sh FRANA SOURCE WORK [SECONDS [RANKS]]        by default an hour on one rank
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/program/common.sh" "$@"
seconds=${4:-3600} n=${5:-1} step=3.3569e-5
# 1. memory: growth in ten minutes, kB    2. energy balance of the solid, as a fraction of the work done
growth_most=1024 balance_most=0.001
scene | sed -e '/name: fracture/s/steps: [0-9]*/steps: 1000000000/; s/substeps: 4/substeps: auto/' \
  -e 's/series_every: .*/series_every: 50/; s/fields_every: .*/fields_every: 5000/' \
  -e 's/checkpoint_every: .*/checkpoint_every: 5000/' >calm.yaml
value() { sed -n "s/.*\"$2\": *\([-0-9.e+]*\).*/\1/p" "$1/run.json" | head -n 1; }

# Measures the number of steps a second, which gives the length of the run.
code 75 ranks "$n" run calm.yaml --out calm --max-wall "$((seconds < 300 ? 5 : 15))"
end=$(awk -v steps="$(value calm steps)" -v wall="$(value calm wall_seconds)" -v setup="$(value calm setup_seconds)" \
  -v s="$seconds" -v dt=$step 'BEGIN { print s * steps / (wall - setup) * dt }')
# A kick: 2 ms in one direction, 2 ms in the other, after which free parts are at rest again; at most 50 kicks. They
# grow by a constant factor, a hundredfold in all: the block is broken completely at a tenth of the last kick, half way
# through the run, or earlier or later if the machine's speed has changed.
kicks=$(awk -v end="$end" 'BEGIN {
  count = int(end / 0.03); if (count > 50) count = 50
  printf "[[0, 0]"
  for (k = 1; k <= count; k++) { t = 0.05 + (0.95 * end - 0.05) * k / count; f = 0.01 * 100 ^ (k / count)
    printf ", [%.6f, 0], [%.6f, %.5f], [%.6f, %.5f], [%.6f, %.5f], [%.6f, %.5f], [%.6f, 0]",
      t, t + 1e-4, f, t + 2e-3, f, t + 2.2e-3, -f, t + 4.1e-3, -f, t + 4.2e-3 }
  print "]" }')
push="{low: [0, -0.01, 0], high: [0.05, 0.035, 0.025], force: [6.0e5, 6.0e5, 0], time: $kicks}"
sed "/^coupling:/i\\  loads:\n    - $push" calm.yaml >scene.yaml

from=$EPOCHREALTIME
mpiexec -n "$n" "$frana" run scene.yaml --out run --max-wall "$seconds" >out 2>err & mpiexec=$!
trap 'kill $mpiexec 2>/dev/null || true' EXIT
echo seconds,process,kB >memory.csv
while sleep $((seconds < 600 ? 2 : 5)); kill -0 $mpiexec 2>/dev/null; do
  for pid in $(ranks_of $mpiexec || true); do
    kb=$(awk '/^VmRSS/ { print $2 }' "/proc/$pid/status" 2>/dev/null || true)
    [ -z "$kb" ] || echo "$(awk -v a="$from" -v b="$EPOCHREALTIME" 'BEGIN { print b - a }'),$pid,$kb" >>memory.csv
  done
done
got=0
wait $mpiexec || got=$?
[ $got = 75 ] || { cat out err >&2; fail "exit code $got, not 75"; }

# The least squares slope over the last two fifths, of each rank: contact's lists have grown by then, with the bonds
# broken before.
awk -F, -v s="$seconds" -v n="$n" -v most=$growth_most '
  NR > 1 && $1 > 0.6 * s && $1 < s { m[$2]++; x[$2] += $1; y[$2] += $3; xx[$2] += $1 * $1; xy[$2] += $1 * $3 }
  END {
    for (p in m) { ranks++
      slope = (xy[p] - x[p] * y[p] / m[p]) / (xx[p] - x[p] * x[p] / m[p])
      printf "memory of a rank: %.0f kB, %+.1f kB in ten minutes (%d samples)\n", y[p] / m[p], 600 * slope, m[p]
      if (!(600 * slope < most) || m[p] < 20) bad = 1 }
    exit (bad || ranks != n) }' memory.csv || fail "memory grows, or was not seen on each rank: $PWD/memory.csv"

# Mass and momentum are tested in every row; the solid's energy balance from the first fifth to the last; and that bonds
# broke.
awk -F, -v most=$balance_most '
  function hold(name, x, limit) {
    if (!(x <= limit)) { print name, x, "is more than", limit, "in step", $1 > "/dev/stderr"; bad = 1 }
    if (x > worst[name]) worst[name] = x }
  function abs(x) { return x < 0 ? -x : x }
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 {
    hold("div_max", $at["div_max"], 1e-10)
    force = sqrt($at["forcing_x"] ^ 2 + $at["forcing_y"] ^ 2 + $at["forcing_z"] ^ 2)
    if (force > largest) largest = force
    # little force is left
    hold("momentum_residual over the largest forcing", $at["momentum_residual"] * force / largest, 1e-11)
    hold("u_bulk off by", abs($at["u_bulk"] / 0.1 - 1), 1e-10)
    rows++
    balance[rows] = $at["e_kinetic_solid"] + $at["e_strain"] + $at["e_damped"] + $at["e_fracture"] - $at["work_fluid"]
    work[rows] = $at["work_fluid"]; broken[rows] = $at["bonds_broken"]
    outside[rows] = $at["particles_outside"]; pieces = $at["fragments"] }
  END {
    fifth = int(rows / 5)
    for (i = 1; i <= fifth; i++) { early += balance[fifth + i] / fifth; late += balance[rows - fifth + i] / fifth }
    for (i = fifth + 1; i <= rows; i++) through += abs(work[i] - work[i - 1])
    for (name in worst) printf "%s: at most %.2g\n", name, worst[name]
    printf "the solid'\''s energy balance: off by %.3g J of %.3g J exchanged\n", late - early, through
    printf "steps %d, bonds broken %d, then %d, fragments %d, particles outside %d, then %d\n", $1, broken[fifth],
      broken[rows], pieces, outside[1], outside[rows]
    if (!(abs(late - early) <= most * through)) { print "the energy balance drifts" > "/dev/stderr"; bad = 1 }
    if (!(broken[rows] > broken[fifth])) { print "nothing breaks after the first fifth" > "/dev/stderr"; bad = 1 }
    if (!(outside[rows] > outside[1])) { print "no fragment has left" > "/dev/stderr"; bad = 1 }
    exit (bad || rows < 50) }' run/series.csv || fail "see $PWD/run/series.csv"
rm -rf calm run/fields run/checkpoint
echo ok
