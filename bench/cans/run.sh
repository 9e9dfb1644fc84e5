#!/usr/bin/env bash
# A step of the fluid alone in CaNS and in frana, in turn, on the same number of ranks:
#     bench/cans/run.sh --cans DIR [--frana PROGRAM] [--ranks N] [--steps N] [--repeats N] [--out DIR]
# DIR holds a built CaNS of the versions that read input.nml and know its dt_f, dtmax and gtype: the program is
# DIR/cans, DIR/run/cans, DIR/build/cans or DIR itself. It must print the time of each step (is_timing, or -D_TIMING).
# Two flows: 128 x 64 x 64 with an inflow, an outflow and walls in y, and 256 x 128 x 128 periodic in x with walls in y,
# driven at a mean velocity. CaNS takes the same axes, sides and cells, explicit diffusion and a given step. Its inflow
# is uniform, and its outflow has a given pressure. The last lines are CaNS's time a step divided by frana's, medians
# over the repeats. --out writes DIR/cans.csv. Tried with a stand-in only (tests/program/bench/cans.sh).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
frana=$here/../../build/frana cans='' ranks=2 steps=40 repeats=5 out=''
fail() { echo "run.sh: $*" >&2; exit 2; }
while [ $# -gt 0 ]; do
  case $1 in
    --frana | --cans | --ranks | --steps | --repeats | --out)
      [ $# -gt 1 ] || fail "$1 needs a value"; printf -v "${1#--}" %s "$2"; shift 2 ;;
    *) fail "$1: unknown option; there are --cans, --frana, --ranks, --steps, --repeats and --out" ;;
  esac
done
for name in ranks steps repeats; do
  [[ ${!name} =~ ^[1-9][0-9]*$ ]] || fail "--$name ${!name}: must be a whole number, at least 1"
done
[ -x "$frana" ] || fail "$frana: there is no such program; build it, or name it with --frana"
[ -n "$cans" ] || fail "--cans DIR: where a built CaNS is, is missing"
for at in "$cans" "$cans/cans" "$cans/run/cans" "$cans/build/cans"; do
  if [ -f "$at" ] && [ -x "$at" ]; then program=$(realpath "$at"); fi
done
[ -n "${program:-}" ] || fail "$cans: there is no program cans, run/cans or build/cans"
frana=$(realpath "$frana")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
launch=(mpiexec -n "$ranks")

# input CELLS INFLOW: CaNS's input.nml for flows of spacing 1/64 of the channel's width of 64 cells, in units of width
# and mean velocity; the Reynolds number is that of frana's bench, 0.1 m/s x 0.1 m / 1e-6 m2/s
input() {
  local never=1000000 n x="'P','P'" pressure="'P','P'" velocity='0.,0.' forced=T start=poi
  IFS=x read -ra n <<<"$1"
  if [ "$2" = 1 ]; then x="'D','N'" pressure="'N','D'" velocity='1.,0.' forced=F start=uni; fi
  local across=${x/\'D\'/\'N\'}
  cat <<END
&dns
ng(1:3) = ${n[0]}, ${n[1]}, ${n[2]}
l(1:3) = $(awk "BEGIN { print ${n[0]} / 64 \", \" ${n[1]} / 64 \", \" ${n[2]} / 64 }")
gtype = 1, gr = 0.
cfl = 0.5, dtmax = 1.e5, dt_f = 1.e-3
visci = 10000.
inivel = '$start'
is_wallturb = F
nstep = $steps, time_max = 100., tw_max = 1.
stop_type(1:3) = T, F, F
restart = F, is_overwrite_save = T, nsaves_max = 0
icheck = $never, iout0d = $never, iout1d = $never, iout2d = $never, iout3d = $never, isave = $never
cbcvel(0:1,1:3,1) = $x, 'D','D', 'P','P'
cbcvel(0:1,1:3,2) = $across, 'D','D', 'P','P'
cbcvel(0:1,1:3,3) = $across, 'D','D', 'P','P'
cbcpre(0:1,1:3) = $pressure, 'N','N', 'P','P'
bcvel(0:1,1:3,1) = $velocity, 0.,0., 0.,0.
bcvel(0:1,1:3,2) = 0.,0., 0.,0., 0.,0.
bcvel(0:1,1:3,3) = 0.,0., 0.,0., 0.,0.
bcpre(0:1,1:3) = 0.,0., 0.,0., 0.,0.
bforce(1:3) = 0., 0., 0.
is_forced(1:3) = $forced, F, F
velf(1:3) = 1., 0., 0.
dims(1:2) = 1, $ranks
/
&numerics
is_impdiff = F, is_impdiff_1d = F
/
&other_options
is_debug = F, is_timing = T
/
END
}
# theirs CELLS INFLOW: the median of the steps' times of the slowest rank, ms, the first quarter of the steps left out
theirs() {
  local folder=$work/$1
  mkdir -p "$folder/data"
  input "$1" "$2" >"$folder/input.nml"
  # CaNS keeps arrays of the size of its grid on the stack; without the right to lift the limit, as far as allowed
  (cd "$folder" && { ulimit -s unlimited 2>/dev/null || ulimit -s hard; } && "${launch[@]}" "$program" >log 2>&1) ||
    { tail -n 5 "$folder/log" >&2; fail "CaNS failed with $1 cells"; }
  # the words of CaNS 2 and 3, and those of CaNS 4; the numbers stand on the next line
  awk 'next_is { print 1e3 * $3 } { next_is = /(Avrg, min & max|Average, minimum & maximum) elapsed time/ }' \
    "$folder/log" |
    tail -n +$((steps / 4 + 1)) >"$folder/times"
  [ -s "$folder/times" ] || fail "CaNS has not printed the times of its steps: build it with -D_TIMING"
  spread "$folder/times" | cut -d ' ' -f 1
}
# ours PART CELLS: the same of frana, from the table that `frana bench` has just written
ours() {
  awk -F, -v part="$1" -v size="$2" '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    $at["part"] == part && $at["size"] == size { print $at["median_ms"] }' "$work"/frana/*-"$ranks".csv
}
# middle LOW HIGH of the numbers in a file, one a line
spread() {
  sort -g "$1" | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2, v[1], v[NR] }'
}

flows=(fluid_step:128x64x64:1 channel_step:256x128x128:0)
for ((k = 1; k <= repeats; k++)); do
  for flow in "${flows[@]}"; do
    IFS=: read -r part cells inflow <<<"$flow"
    theirs "$cells" "$inflow" >>"$work/theirs.$part"
  done
  "${launch[@]}" "$frana" bench --only fluid --repeats 5 --out "$work/frana" >/dev/null
  for flow in "${flows[@]}"; do
    IFS=: read -r part cells inflow <<<"$flow"
    our_ms=$(ours "$part" "$cells") their_ms=$(tail -n 1 "$work/theirs.$part")
    [ -n "$our_ms" ] || fail "frana bench has no row $part, $cells"
    echo "$cells: CaNS $their_ms ms a step, frana $our_ms"
    echo "$our_ms" >>"$work/ours.$part"
    awk "BEGIN { print $their_ms / $our_ms }" >>"$work/ratio.$part"
  done
done
table=$work/cans.csv
echo "code,part,size,ranks,theirs_ms,ours_ms,ratio,spread" >"$table"
for flow in "${flows[@]}"; do
  IFS=: read -r part cells inflow <<<"$flow"
  read -r their_ms _ < <(spread "$work/theirs.$part")
  read -r our_ms _ < <(spread "$work/ours.$part")
  read -r ratio low high < <(spread "$work/ratio.$part")
  printf 'CaNS,%s,%s,%s,%.4g,%.4g,%.2f,%.2f-%.2f\n' \
    "$part" "$cells" "$ranks" "$their_ms" "$our_ms" "$ratio" "$low" "$high" >>"$table"
  printf '%s, %s ranks: CaNS %.4g ms, frana %.4g ms a step (medians of %d), ratio %.2f, spread %.2f-%.2f\n' \
    "$cells" "$ranks" "$their_ms" "$our_ms" "$repeats" "$ratio" "$low" "$high"
done
if [ -n "$out" ]; then mkdir -p "$out" && cp "$table" "$out/cans.csv"; fi
