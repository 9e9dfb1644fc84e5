#!/usr/bin/env bash
# Runs the plate with the source's weights, with other weights, and on finer grids. Writes results/.
# usage: cases/duran_50/run.sh [RUNS]      (runs/duran_50)
#        cases/duran_50/run.sh --summary     runs nothing: judges the numbers of results/measured.csv again
# FRANA is the program (build/frana). Finished runs are kept.
# shellcheck disable=SC2046,SC2086 # settings are words on purpose
set -euo pipefail
cd "$(dirname "$0")/../.."
case=cases/duran_50 runs=${1:-runs/duran_50} scene=$case/scene.yaml out=$case/results
. cases/crack.sh
mkdir -p "$out"
axis=0.02 reach=0.005
ratio() { echo "--set solid.materials[0].horizon_ratio=$1"; }

go m3 $scene
go m3_ramp $scene --set solid.partial_volume=ramp --set solid.surface_correction=false
go m3.5 $scene $(ratio 3.5)
go m4 $scene $(ratio 4)
# Bonds up to 3.5 spacings with c0 and s0 of a horizon of 3: the same as a plate with E (3.5/3)^3 and G0 (3.5/3)^4.
go m3.5_of_3 $scene $(ratio 3.5) --set solid.materials[0].youngs_modulus=103.218e9 \
  --set solid.materials[0].fracture_energy=377.94
go m3_half $scene --set solid.spacing=5.0e-4
go m3.5_half $scene $(ratio 3.5) --set solid.spacing=5.0e-4

summary_begin "$out/summary.csv"
us() { scaled 1e6 "$(of "$1" "$2")"; }
for n in m3 m3_ramp m3.5; do
  row "$n: crack begins to open, its tip has moved" us \
    "$(us $n "start of growth: tip moved by more than a spacing, t")" "about 10" "003 ch. 7" 9 11
  row "$n: first bond breaks" us "$(us $n "start of growth: first broken bond, t")" "about 10" "003 ch. 7" 9 11
  row "$n: branches' ways meet at x" mm "$(scaled 1e3 "$(meet $n $axis $reach)")" "about 70" "003 ch. 7" 66.5 73.5
  row "$n: branches are seen" us "$(us $n "branching: fronts apart from then on, t")" "about 30" "003 ch. 7" 27 33
  row "$n: undamaged particles part them from x" mm "$(scaled 1e3 "$(of $n "branching, x")")" "about 70" "003 ch. 7" \
    66.5 73.5
  row "$n: level of the damage contour" 1 "$(scaled 1 "$(of $n "level of the damage contour")")" 0.41 "003 ch. 3" 0.40 \
    0.42
  row "$n: top speed" m/s "$(scaled 1 "$(of $n "top speed of the tip")")" "below Rayleigh's" \
    "$(of $n "Rayleigh speed") m/s" 0 "$(of $n "Rayleigh speed")"
  mirrored "$n" $axis 1.0e-3
  shown "$n: wall time" s "$(scaled 1 "$(json $n wall_seconds)")" "" ""
done
[ ! "$again" ] || { finish; exit; }
{
  echo "choice, particles, first bond us, tip moved us, branches seen us, ways meet mm, undamaged between from mm," \
    "top speed end to end m/s, top speed m/s, released over G0"
  for n in m3 m3_ramp m3.5 m4 m3.5_of_3 m3_half m3.5_half; do
    echo "$n, $(json $n particles), $(us $n "start of growth: first broken bond, t")," \
      "$(us $n "start of growth: tip moved by more than a spacing, t")," \
      "$(us $n "branching: fronts apart from then on, t"), $(scaled 1e3 "$(meet $n $axis $reach)")," \
      "$(scaled 1e3 "$(of $n "branching, x")"), $(top $n 2.0e-6), $(of $n "top speed of the tip")," \
      "$(of $n "energy released over the new area, over G0")"
  done
} >"$out/sensitivity.csv"
cp "$runs/m3.5/post/pictures/damage.png" "$out/damage.png"
finish
