#!/usr/bin/env bash
# Consolidation: a porous column that drains at its ends (Terzaghi), a slab between plates that drains at its sides
# (Mandel).
# usage: cases/verification/consolidation/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# of_run NAME READER ARGUMENT...: what a reader of this folder prints in the run
in_run() { (cd "$runs/$1" && "$here/$2" "${@:3}"); }
of_run() { kept "$*" in_run "$@"; }
# profile: p over p_u against the depth beside the series, in the field files of five times
profile() {
  [ ! "$again" ] || return 0
  local n file
  echo "depth,T,pressure,pressure_reference" >"$out/profile.csv"
  echo "#1,1,1,1" >>"$out/profile.csv"
  for n in 4 5 7 13 23; do
    file=$(printf '%s/column/fields/solid_%08d.hdf' "$runs" $((261 * n)))
    paste -d ' ' <(h5_values "$file" /VTKHDF/Points %.9g 3) \
      <(h5_values "$file" /VTKHDF/PointData/crack_pressure %.9g 1) |
      awk -v t="$(calc "261 * $n * 4e-7 - 3.05e-4")" '
        BEGIN { pi = atan2(0, -1); T = t / (1.024e-6 / (1.2 * 1.0220027 * 2e10) / 2e-14) }
        $1 > 4e-3 && $1 < 5e-3 && $2 > 2.4e-3 && $2 < 35e-3 {
          z = ($2 - 2.5e-3) / 0.032; sum = 0
          for (m = 0; m < 100; m++) { M = pi / 2 * (2 * m + 1); sum += 2 / M * sin(M * z) * exp(-M * M * T) }
          printf "%.4g,%.4g,%.6g,%.6g\n", z, T, $4 / 3e6, sum }' | sort -g >>"$out/profile.csv"
    echo >>"$out/profile.csv" # the next line of the picture
  done
}
nu=0.25   # Poisson's ratio of what follows; of_nu: its part of the names of rows
of_nu=""
# column NAME BIOT MODULUS PERMEABILITY PRESSURE STEPS T...: a run of the column, and its rows at each T
column() {
  local name=$1 biot=$2 modulus=$3 k0=$4 which="column$of_nu, alpha = $2, M = ${3/.inf/infinite}"
  run_of "$name" terzaghi.yaml "crack_fluid.pores.biot=$biot" "crack_fluid.pores.modulus=$modulus" \
    "crack_fluid.pores.permeability=$k0" "crack_fluid.injections[1].pressure=$5" \
    "crack_fluid.injections[2].pressure=$5" "stages[0].steps=$6" "solid.materials[0].poisson_ratio=$nu"
  shift 6
  shown "$which: pressure of the sealed column over p_u" 1 \
    "$(of_run "$name" column.sh "$biot" "$modulus" "$k0" "$nu" 1 sealed)" 1 exact
  for T in "$@"; do
    near "$which: pressure at the base over p_u, T = $T" 1 \
      "$(of_run "$name" column.sh "$biot" "$modulus" "$k0" "$nu" "$T" pressure)" "$(known_at "$T" 2)" series 0.02
    U=$(known_at "$T" 3)
    # the drained plane is known to half a spacing of 32: its distance H, and with it U in proportion, to 1/64
    near "$which: part of the settlement, T = $T" 1 \
      "$(of_run "$name" column.sh "$biot" "$modulus" "$k0" "$nu" "$T" settlement)" "$U" series "$(calc '1 / 64')"
  done
}
# known_at T COLUMN: the series (physics/consolidation.h)
# T: p/p_u at the base, settlement; of the slab p/p0 in the middle: M infinite; alpha = 0.8, M = 2 E
known_at() {
  awk -v T="$1" -v c="$2" '$1 == T { print $c; found = 1 } END { exit !found }' <<'END'
0.01 1.000000 0.112838 1.03875 1.02357
0.05 0.996869 0.252313 1.08676 1.05075
0.1  0.949305 0.356823 1.07755 1.02526
0.2  0.772312 0.504088 0.94304 0.87148
0.5  0.370777 0.763950 0.56099 0.47575
1    0.107977 0.931260 0.23345 0.17159
2    0.009157 0.994170 0.04043 0.02232
END
}
# series_at T: p/p0 in the middle of the slab that is being read; of nu = 1/4 from the table
series_at() {
  if [ "$nu" = 0.25 ]; then
    known_at "$1" "$column"
  else
    "$here/mandel.sh" "${scene[@]}" series "$1"
  fi
}
# slab NAME HALF BIOT MODULUS PERMEABILITY STEPS COLUMN T...: a run of the slab, and its rows at each T
slab() {
  local name=$1 scene=("$2" "$3" "$4" "$5" "$nu") column=$7
  local which="slab$of_nu, a = $2 h, alpha = $3, M = ${4/.inf/infinite}"
  if [ ! "$again" ]; then
    "$here/mandel.sh" "${scene[@]}" "$6" >"$runs/$name.yaml"
    rm -rf "${runs:?}/$name"
    "$frana" run "$runs/$name.yaml" --out "$runs/$name" --quiet >"$runs/$name.log" 2>&1 ||
      { cat "$runs/$name.log" >&2; exit 1; }
  fi
  shift 7
  shown "$which: pressure of the sealed slab over p_0, k0 = ${scene[3]} m2" 1 \
    "$(of_run "$name" mandel.sh "${scene[@]}" number 1 sealed)" 1 exact
  for T in "$@"; do
    near "$which: pressure in the middle over p_0, T = $T" 1 \
      "$(of_run "$name" mandel.sh "${scene[@]}" number "$T" pressure)" "$(series_at "$T")" series 0.03
    near "$which: reaction of the plates over the load, T = $T" 1 \
      "$(of_run "$name" mandel.sh "${scene[@]}" number "$T" reaction)" 1 exact 0.03
  done
}

if [ "$quick" ]; then
  column quick_column 0.8 4.0e10 5.0e-14 1.91509e6 1310 0.1 0.2
  slab quick_slab 16 1 .inf 3.4e-14 450 4 0.05 0.1 0.2 0.5
  finish
  exit
fi
column column 1 .inf 2.0e-14 3.0e6 11250 0.01 0.05 0.1 0.2 0.5 1 2
column column_compressible 0.8 4.0e10 2.5e-14 1.91509e6 11250 0.01 0.05 0.1 0.2 0.5 1 2
# T below 0.1 in a slower run: inertia counts there
slab slab_early 32 1 .inf 8.2e-15 1330 4 0.01 0.05 0.1
slab slab 32 1 .inf 6.8e-14 3150 4 0.2 0.5 1 2
slab slab_compressible_early 32 0.8 4.0e10 1.03e-14 1330 5 0.01 0.05 0.1
slab slab_compressible 32 0.8 4.0e10 8.5e-14 3150 5 0.2 0.5 1 2
for nu in 0.2 0.35; do # the pressure against T does not depend on nu in the column, in the slab it does
  of_nu=", nu = $nu"
  column "column_$nu" 1 .inf 2.0e-14 3.0e6 11250 0.05 0.1 0.2 0.5 1
  slab "slab_$nu" 32 1 .inf 6.8e-14 3150 4 0.2 0.5 1
done
nu=0.25 of_nu=""
profile
if [ ! "$again" ]; then
  for name in column column_compressible; do
    awk 'NR <= 2 || NR % (NR < 100 ? 5 : 50) == 0' "$runs/$name/column.csv" >"$out/$name.csv"
  done
  for name in slab slab_early slab_compressible slab_compressible_early; do
    awk 'NR <= 2 || NR % 2 == 0' "$runs/$name/slab.csv" >"$out/$name.csv"
  done
  ! command -v gnuplot >/dev/null || "$here/draw.sh" "$(realpath "$out")"
fi
finish
