#!/usr/bin/env bash
# Runs the three cracks on uniform grids, on grids refined at the crack, and with the hole in the middle of the plate.
# usage: cases/plate_hole/run.sh [RUNS]      writes results/ (RUNS: runs/plate_hole)
#        cases/plate_hole/run.sh --summary     runs nothing: judges the numbers of results/measured.csv again
# shellcheck disable=SC2046,SC2086 # settings are words on purpose
set -euo pipefail
cd "$(dirname "$0")/../.."
runs=${1:-runs/plate_hole} case=cases/plate_hole out=cases/plate_hole/results
. cases/crack.sh
mkdir -p "$out"
# grid SPACING: settings for this spacing, with a clamp of one layer
grid() { echo "--set solid.spacing=$1 --set solid.constraints[0].high=[0.03,$1]"; }
# path NAME X Y RADIUS WIDTH: five results of the crack that continues the initial one: the time (s) at which its tip
# has moved by 1 mm; the tip's x and its y at the end (mm); the distance from there to the edge of the hole (mm); a word
# for the outcome
path() {
  awk -F, -v cx="$2" -v cy="$3" -v r="$4" -v width="$5" '
    NR < 3 { next }
    NR == 3 { x0 = $3 }
    { x = $3; y = $4; if (!start && x > x0 + 0.001) start = $2 }
    END { gap = sqrt((x - cx) ^ 2 + (y - cy) ^ 2) - r
      printf "%.4g %.4g %.4g %.2f %s\n", start, 1e3 * x, 1e3 * y, 1e3 * gap,
        (gap < 0.002 ? "drawn_in" : x > width - 0.003 ? "passes" : "stops") }' "$runs/$1/crack.csv"
}
# measured NAME X Y RADIUS OUTCOME [PARTICLES]: writes the rows of a run. OUTCOME is that of
# 000 (-: it names none).
measured() {
  local p o=${5#-}
  read -r -a p <<<"$(kept "$1: path" path "$1" "$2" "$3" "$4" 0.03)"
  shown "$1: the crack starts" s "${p[0]}" "" ""
  shown "$1: x of the tip at the end" mm "${p[1]}" "" ""
  shown "$1: y of the tip at the end" mm "${p[2]}" "" ""
  shown "$1: from there to the hole" mm "${p[3]}" "" ""
  shown "$1: what becomes of the crack" "" "${p[4]}" "$o" "${o:+the hole was placed so that this is the outcome}"
  shown "$1: particles at the end" 1 "$(json "$1" particles)" "${6-}" "${6:+000 table 15}"
  shown "$1: wall time of the steps" s "$(json "$1" wall_seconds | cut -c 1-5)" "" ""
}

middle="--set domain.size=[0.03,0.045] --set solid.bodies.plate.high=[0.03,0.045]
  --set solid.loads[0].edge.from=[0,0.045] --set solid.loads[0].edge.to=[0.03,0.045]
  --set solid.bodies.plate.holes[0].centre=[0.015,0.0225] --set solid.bodies.plate.holes[0].radius=0.006"
summary_begin "$out/summary.csv"
while read -r m from outcome nodes load; do
  variation ${m}_1mm $case/$m.yaml
  variation ${m}_factor_1mm $case/$m.yaml --set solid.loads[0].traction=[0,$load] # 000's table 14, by its factor
  variation ${m}_refined $case/$m.yaml --set "solid.refinement={levels:_1,energy:_0.7,damage:_0.01,from:_$from}"
  variation ${m}_half_mm $case/$m.yaml $(grid 5.0e-4)
  variation ${m}_quarter_mm $case/$m.yaml $(grid 2.5e-4) --set output.fields_every=0
  variation ${m}_middle_1mm $case/$m.yaml $middle
  variation ${m}_middle_half_mm $case/$m.yaml $middle $(grid 5.0e-4)
  measured ${m}_1mm 0.02 0.008 0.004 "$outcome" 1238
  measured ${m}_factor_1mm 0.02 0.008 0.004 "$outcome" 1238
  measured ${m}_refined 0.02 0.008 0.004 "$outcome" "$nodes"
  measured ${m}_half_mm 0.02 0.008 0.004 "$outcome"
  measured ${m}_quarter_mm 0.02 0.008 0.004 "$outcome"
  measured ${m}_middle_1mm 0.015 0.0225 0.006 - 1238
  measured ${m}_middle_half_mm 0.015 0.0225 0.006 -
done <<'MODELS'
a 1.92e-5 passes 1927 2.127e7
b 1.80e-5 - 2409 2.513e7
c 1.92e-5 drawn_in 2492 2.900e7
MODELS
# A crack's end on 0.5 mm is within the horizon of that grid, 1.5 mm, of its end on 0.25 mm.
ends() { sed -n "s/^\"$1: path\",//p" "$measured"; }
for m in a b c; do
  same "$m: what becomes of the crack under the load of 000's table 14" "" "$(ends ${m}_factor_1mm | cut -d ' ' -f 5)" \
    "$(ends ${m}_1mm | cut -d ' ' -f 5)" "the load of the scene, without 000's surface factor"
  read -r _ x y _ x2 y2 _ <<<"$(ends ${m}_half_mm | cut -d ' ' -f 1-3) $(ends ${m}_quarter_mm)"
  at_most "$m: the tip's end on 0.5 mm from that on 0.25 mm" mm "$(calc "sqrt(($x - $x2) ^ 2 + ($y - $y2) ^ 2)")" 0 \
    "the finer grid: within the coarser one's horizon" 1.5
done
[ "$again" ] || for n in {a,c}_half_mm/damage {a,b,c}_refined/displacement_y; do
  cp "$runs/${n%/*}/post/pictures/${n#*/}.png" "$out/${n%/*}.png"; done
finish
