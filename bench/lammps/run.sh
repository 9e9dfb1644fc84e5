#!/usr/bin/env bash
# The force sweep of a full block of 54,872 particles in LAMMPS (pair_style peri/pmb, and peri/lps beside frana's
# material with nu = 0.2) and in frana, in turn, on one rank each:
#     bench/lammps/run.sh [--frana PROGRAM] [--repeats N] [--out DIR] [--install]
# Each twice: with bonds up to 3 spacings (122 neighbours inside the block, LAMMPS's family for this horizon), and with
# the 178 bonds of frana's horizon of 3 spacings. The last line is `ratio X`: LAMMPS's time a directed bond divided by
# frana's for the first family in double, median over the repeats; a line before it has the ratio of mixed precision.
# --out writes DIR/lammps.csv, and DIR/lammps_lps.csv of the linear solid with 178 bonds.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
frana=$here/../../build/frana repeats=5 out='' install=''
fail() { echo "run.sh: $*" >&2; exit 2; }
while [ $# -gt 0 ]; do
  case $1 in
    --frana | --repeats | --out) [ $# -gt 1 ] || fail "$1 needs a value"; printf -v "${1#--}" %s "$2"; shift 2 ;;
    --install) install=1; shift ;;
    *) fail "$1: unknown option; there are --frana, --repeats, --out and --install" ;;
  esac
done
[[ $repeats =~ ^[0-9]+$ ]] && [ "$repeats" -ge 5 ] || fail "--repeats $repeats: must be a whole number, at least 5"
[ -x "$frana" ] || fail "$frana: there is no such program; build it, or name it with --frana"
if ! command -v lmp >/dev/null && [ -n "$install" ]; then apt-get install -y lammps >/dev/null; fi
command -v lmp >/dev/null || fail "LAMMPS is missing: apt-get install lammps, or run this again with --install"
lmp -help 2>/dev/null | grep 'peri/pmb' >/dev/null ||
  fail "this LAMMPS ($(command -v lmp)) is built without its PERI package"
frana=$(realpath "$frana")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# theirs REACH LAW: number of directed bonds, and time a bond, ns, as LAMMPS reports it for its pair style in the last
# run
theirs() {
  local steps=8
  lmp -in "$here/in.pmb" -var side 38 -var reach "$1" -var law "$2" -var steps $steps -log "$work/log" -screen none ||
    fail "LAMMPS failed"
  awk -v steps=$steps '
    /total # of bonds/ { bonds = $NF }
    /^Pair / { pair = $3 }
    /^Step/ { getline; getline; worst = $3 } # damage after the last step
    END { if (worst != 0 || !bonds) exit 1; printf "%d %.4f\n", bonds, 1e9 * pair / steps / bonds }' "$work/log" ||
    fail "bonds are missing or broken in LAMMPS"
}
# ours PART: the same for frana, from the table that `frana bench` has just written
ours() {
  awk -F, -v part="$1" '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    $at["part"] == part { printf "%.0f %s\n", $at["units"], $at["ns_per_unit"] }' "$work"/frana/*-1.csv
}
# middle LOW HIGH of the numbers in a file, one a line
spread() {
  sort -g "$1" | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2, v[1], v[NR] }'
}

for ((k = 1; k <= repeats; k++)); do
  for reach in 122:3.0001 178:3.4999; do theirs "${reach#*:}" pmb >"$work/theirs.${reach%:*}"; done
  theirs 3.4999 lps >"$work/theirs.lps"
  "$frana" bench --only peer --repeats 5 --out "$work/frana" >/dev/null
  for n in 122 178; do
    ours sweep_$n >"$work/ours.$n"
    read -r their_bonds their_ns <"$work/theirs.$n"
    read -r our_bonds our_ns <"$work/ours.$n"
    [ "$their_bonds" = "$our_bonds" ] || fail "$n neighbours: LAMMPS has $their_bonds directed bonds, frana $our_bonds"
    echo "$n neighbours, $our_bonds directed bonds in both: LAMMPS $their_ns ns a bond, frana $our_ns"
    echo "$their_ns" >>"$work/theirs.$n.all"
    echo "$our_ns" >>"$work/ours.$n.all"
    awk "BEGIN { print $their_ns / $our_ns }" >>"$work/ratio.$n.all"
    ours "sweep_${n}_mixed" >"$work/mixed.$n"
    read -r _ mixed_ns <"$work/mixed.$n"
    awk "BEGIN { print $their_ns / $mixed_ns }" >>"$work/ratio.$n.mixed"
  done
  read -r their_bonds their_ns <"$work/theirs.lps"
  read -r our_bonds our_ns < <(ours sweep_178_dilated)
  [ "$their_bonds" = "$our_bonds" ] || fail "peri/lps: LAMMPS has $their_bonds directed bonds, frana $our_bonds"
  echo "$their_ns" >>"$work/theirs.lps.all"
  echo "$our_ns" >>"$work/ours.lps.all"
  awk "BEGIN { print $their_ns / $our_ns }" >>"$work/ratio.lps.all"
done
table=$work/lammps.csv
echo "code,bonds,theirs_ns,ours_ns,ratio,spread" | tee "$table" >"$work/lammps_lps.csv"
read -r their_ns _ < <(spread "$work/theirs.lps.all")
read -r our_ns _ < <(spread "$work/ours.lps.all")
read -r ratio low high < <(spread "$work/ratio.lps.all")
printf 'LAMMPS PERI/LPS,%s,%.3g,%.3g,%.1f,%.1f-%.1f\n' "$our_bonds" "$their_ns" "$our_ns" "$ratio" "$low" "$high" |
  tee -a "$work/lammps_lps.csv"
for n in 178 122; do
  read -r their_ns _ < <(spread "$work/theirs.$n.all")
  read -r our_ns _ < <(spread "$work/ours.$n.all")
  read -r ratio low high < <(spread "$work/ratio.$n.all")
  read -r bonds _ <"$work/ours.$n"
  printf 'LAMMPS PERI/PMB,%s,%.3g,%.3g,%.1f,%.1f-%.1f\n' \
    "$bonds" "$their_ns" "$our_ns" "$ratio" "$low" "$high" >>"$table"
  printf '%s neighbours: LAMMPS %.3g ns, frana %.3g ns a directed bond (medians of %d)\n' \
    $n "$their_ns" "$our_ns" "$repeats"
  read -r in_mixed low_mixed high_mixed < <(spread "$work/ratio.$n.mixed")
  printf 'in mixed precision: ratio %.1f, spread %.1f-%.1f\n' "$in_mixed" "$low_mixed" "$high_mixed"
  printf 'spread %.1f-%.1f\nratio %.1f\n' "$low" "$high" "$ratio"
done
if [ -n "$out" ]; then mkdir -p "$out" && cp "$table" "$work/lammps_lps.csv" "$out"; fi
