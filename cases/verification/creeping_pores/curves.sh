#!/usr/bin/env bash
# Error of k against run time on 1, 2 and 3 cells a voxel: solved at once (three axes), extrapolated from two grids,
# stepped in time with implicit diffusion (along x), and by Palabos (lattice Boltzmann, along x) where it is installed
# (Debian: libplb-dev, libeigen3-dev). Columns: cells a voxel, 0: two grids; k over the reference less 1; seconds, the
# least of REPEATS runs, three if it is not set.
# usage: curves.sh [FRANA [RUNS [OUT]]]    writes OUT/curves.csv and OUT/curves.png
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
frana=$(realpath "${1:-build/frana}") runs=${2:-runs/verification/creeping_pores_curves}
out=$(realpath "${3:-$here/results}")
repeats=$(seq "${REPEATS:-3}")
mkdir -p "$runs" "$out" && cd "$runs"
value() { awk -F, -v q="$2" '$1 == q { print $2 }' "$1"; }
# the permeability between plates or in a duct b x a, b <= a, over its area: Fourier series
duct() { awk -v a="$1" -v b="$2" 'BEGIN {
  pi = atan2(0, -1); s = 1
  for (n = 1; n < 200; n += 2) { e = exp(-n * pi * a / b); s -= 192 * b / (pi * n) ^ 5 / a * (1 - e) / (1 + e) }
  printf "%.12g", b * b / 12 * s }'; }
palabos=
if mpic++ -O3 -march=native -std=gnu++11 -w -DCOARSE_GRID_PROCESSORS_3D_HH -I/usr/include/palabos \
  -I/usr/include/eigen3 "$here/palabos.cpp" -o palabos -lplb 2>palabos.log; then
  palabos=1
else
  echo "without Palabos: $PWD/palabos.log"
fi

at_once() { # at_once NAME CELLS_A_VOXEL OPTIONS..: k, seconds
  local name=$1 finer=$2; shift 2
  "$frana" permeability "$here/scene.yaml" --quiet --out "$name-$finer" --set "domain.cells=[$((N * finer)), \
$((N * finer)), $((N * finer))]" --set "solid.bodies=[{name: rock, shape: image, file: '$PWD/$name.raw',
    size: [$N, $N, $N], type: uint8, voxel: $edge, solid: [1], low: [0, 0, 0]}]" "$@" >log
}
row() { # row METHOD CELLS K SECONDS
  awk -v s="$sample" -v m="$1" -v c="$2" -v k="$3" -v r="$reference" -v t="$4" \
    'BEGIN { printf "%s,%s,%d,%.5g,%.3g\n", s, m, c, k / r - 1, t }' >>curves.new
}
least() { sort -g | head -1; }
measure() { # measure SAMPLE N REFERENCE CONDITION; REFERENCE in voxels, "": this program on 2, 4 and 8 cells a voxel
  sample=$1 N=$2 reference=$3
  edge=$(awk -v n="$N" 'BEGIN { printf "%.12g", 1 / n }')
  "$here/../voxels.sh" "$N" "$4" >"$sample.raw"
  if [ ! "$reference" ]; then
    for finer in 2 4 8; do at_once "$sample" $finer --quick; done
    reference=$(awk -v a="$(value "$sample-2/permeability.csv" k_xx)" \
      -v b="$(value "$sample-4/permeability.csv" k_xx)" -v c="$(value "$sample-8/permeability.csv" k_xx)" -v n="$N" \
      'BEGIN { q = (a - b) / (b - c); printf "%.12g", (c - (b - c) / (q - 1)) * n * n }')
  fi
  echo "$sample,reference,0,$reference," >>curves.new
  local finer k seconds
  for finer in 1 2 3; do
    seconds=$(for _ in $repeats; do
      at_once "$sample" $finer --quick; value "$sample-$finer/permeability.csv" seconds_level_1; done | least)
    row "at once" $finer "$(awk -v k="$(value "$sample-$finer/permeability.csv" k_xx)" -v n="$N" \
      'BEGIN { print k * n * n }')" "$seconds"
  done
  seconds=$(for _ in $repeats; do
    at_once "$sample" 1
    awk -F, '/^seconds_level/ { s += $2 } END { print s }' "$sample-1/permeability.csv"
  done | least)
  k=$(value "$sample-1/permeability.csv" k_xx)
  row "two grids" 0 "$(awk -v k="$k" -v n="$N" 'BEGIN { print k * n * n }')" "$seconds"
  for finer in 1 2 3; do
    seconds=$(for _ in $repeats; do
      rm -rf stepped
      "$frana" run "$here/scene.yaml" --quiet --out stepped --set fluid.diffusion=implicit \
        --set "domain.cells=[$((N * finer)), $((N * finer)), $((N * finer))]" \
        --set "solid={spacing: $(awk -v e="$edge" -v f=$finer 'BEGIN { printf "%.15g", e / f }'),
          materials: [{name: rigid, youngs_modulus: 1, density: 1, horizon_ratio: 1}], bodies: [{name: rock,
          shape: image, file: '$PWD/$sample.raw', size: [$N, $N, $N], type: uint8, voxel: $edge, solid: [1],
          low: [0, 0, 0]}]}" --set output.series_every=1 \
        --set 'stages.flow.until={quantity: permeability, change: 1.0e-4, window: 5}' >log
      sed -n 's/.*"wall_seconds": \([0-9.e+-]*\),.*/\1/p' stepped/run.json
    done | least)
    k=$(awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "permeability") c = i } END { print $c }' \
      stepped/series.csv)
    row stepped $finer "$(awk -v k="$k" -v n="$N" 'BEGIN { print k * n * n }')" "$seconds"
  done
  [ "$palabos" ] || return 0
  for finer in 1 2 3; do
    for _ in $repeats; do ./palabos "$N" "$N" "$N" "$sample.raw" 0 $finer 1e-5; done >log
    row Palabos $finer "$(awk '{ print $2; exit }' log)" "$(awk '{ print $6 }' log | least)"
  done
}
echo "sample,method,cells,error,seconds" >curves.new
measure "slit of 4" 8 "$(awk 'BEGIN { print 4 ^ 3 / 12 / 8 }')" 'j >= 4'
measure "duct of 8 x 8" 12 "$(awk -v k="$(duct 8 8)" 'BEGIN { print k * 64 / 144 }')" 'j >= 8 || k >= 8'
measure "duct of 4 x 8" 12 "$(awk -v k="$(duct 8 4)" 'BEGIN { print k * 32 / 144 }')" 'j >= 4 || k >= 8'
measure "cubes of 4 in 8" 8 "" 'i < 4 && j < 4 && k < 4'
measure "columns of 2 in 8" 8 "" '(i == 3 || i == 4) && (j == 3 || j == 4)'
measure "stairs along [110]" 8 "" '(i - j + 8) % 8 >= 4'
measure "body-centred spheres" 12 "" \
  'd(0.26, 0.22, 0.25) < (0.329610382525 * N) ^ 2 || d(0.76, 0.72, 0.75) < (0.329610382525 * N) ^ 2'
mv curves.new "$out/curves.csv"
command -v gnuplot >/dev/null || exit 0
cd "$out"
gnuplot "$here/curves.gp"
