#!/usr/bin/env bash
# Runs the three plates of the source's tables 5 to 7, a finer plate, and variations of the choices. Writes results/.
# usage: cases/soda_lime/run.sh [RUNS]      (runs/soda_lime)
#        cases/soda_lime/run.sh --summary     runs nothing: judges the numbers of results/measured.csv again
# FRANA is the program (build/frana). Finished runs are kept.
# shellcheck disable=SC2016,SC2046,SC2086 # awk in single quotes; settings are words on purpose
set -euo pipefail
cd "$(dirname "$0")/../.."
case=cases/soda_lime runs=${1:-runs/soda_lime} scene=$case/scene.yaml out=$case/results
. cases/crack.sh
mkdir -p "$out"
fine=(--set solid.spacing=5.0e-4)
traction() { echo "--set solid.loads[0].traction=[0,$1] --set solid.loads[1].traction=[0,-$1]"; }
beside='output.probes={every: 10, at: [[0.0495, 0.0205]]}' # the particle above the notch's tip (000: fig. 63)

go uniform_4000 $scene --set "$beside"
go uniform_16000 $scene "${fine[@]}" --set "$beside"
refine='solid.refinement={levels: 1, energy: 0.7, from: 5.7e-6, every: 1}'
go adaptive $scene --set "$refine" --set "$beside"
go traction_22_adaptive $scene $(traction 22.0e6) --set "$refine"
go uniform_64000 $scene --set solid.spacing=2.5e-4
for grid in 4000 16000; do
  spacing=(); [ $grid = 4000 ] || spacing=("${fine[@]}")
  for s in 22 12 11; do go traction_${s}_$grid $scene "${spacing[@]}" $(traction $s.0e6); done
  go ramp_$grid $scene "${spacing[@]}" --set solid.partial_volume=ramp
  go no_correction_$grid $scene "${spacing[@]}" --set solid.surface_correction=false
  go ramp_no_correction_$grid $scene "${spacing[@]}" --set solid.partial_volume=ramp \
    --set solid.surface_correction=false
  go load_over_horizon_$grid $scene "${spacing[@]}" --set solid.loads[0].depth=horizon \
    --set solid.loads[1].depth=horizon
  go half_step_$grid $scene "${spacing[@]}" --set stages[0].time_step=2.5e-8 --set stages[0].steps=2000
done
[ "$again" ] || "$frana" post "$runs"/uniform_4000 "$runs"/uniform_16000 "$runs"/adaptive --out "$runs/compared"

axis=0.02 reach=0.005
summary_begin "$out/summary.csv"
rayleigh=$(of uniform_4000 "Rayleigh speed")
# between QUANTITY UNIT OURS RANGE SOURCE: passes within the source's RANGE, as "26 to 27"
between() { row "$@" "${4% to *}" "${4#* to }"; }
# plate RUN START FORK PLACE FIRST LAST SPEED SECONDS FINEST PARTICLES: writes the rows of one plate with the source's
# numbers. FORK, FIRST and LAST are ranges; START passes within 0.3 us, PLACE within a particle of 1 mm, SPEED within
# 10 %.
plate() {
  local n=$1 s="000 tab. 5" first="start of growth: first broken bond" fork="branching: fronts apart from then on"
  us() { scaled 1e6 "$(of "$n" "$1, t")"; }
  if [ "$n" != "${n#traction}" ]; then # 22 MPa was not on 000's plates: here they must be earlier
    row "$n: starts before 000's plate by" us "$(calc "$2 - $(us "$first")")" "" "$s" 0.3
    row "$n: forks before 000's plate by" us "$(calc "${3% *to*} - $(us "$fork")")" "" "$s" 1
    mirrored "$n" $axis "$9"
    return
  fi
  shown "$n: particles at the end" 1 "$(json "$n" particles)" "${10}" "$s"
  row "$n: initiation" us "$(us "$first")" "$2" "$s" "$(calc "$2 - 0.3")" "$(calc "$2 + 0.3")"
  between "$n: branches are seen" us "$(us "$fork")" "$3" "$s"
  shown "$n: tip passes where undamaged particles part them" us "$(us "branching: tip passes the place")" "$3" "$s"
  row "$n: branches' ways meet at x" mm "$(scaled 1e3 "$(meet "$n" $axis $reach)")" "$4" "$s" \
    "$(calc "$4 - 1")" "$(calc "$4 + 1")"
  row "$n: undamaged particles part them from x" mm "$(scaled 1e3 "$(of "$n" "branching, x")")" "$4" "$s" \
    "$(calc "$4 - 1")" "$(calc "$4 + 1")"
  between "$n: angle at first" deg "$(scaled 1 "$(of "$n" "angle of the branch to the left, at first")")" "$5" "$s"
  between "$n: angle at last" deg "$(scaled 1 "$(of "$n" "angle of the branch to the left, at last")")" "$6" "$s"
  row "$n: top speed, windows of 2 us end to end" m/s "$(top "$n" 2.0e-6)" "$7" "000 tab. 6, eq. 41" \
    "$(scaled 0.9 "$7")" "$(scaled 1.1 "$7")"
  row "$n: top speed, any window of 2 us" m/s "$(scaled 1 "$(of "$n" "top speed of the tip")")" "below Rayleigh's" \
    "$(scaled 1 "$rayleigh") m/s" 0 "$rayleigh"
  mirrored "$n" $axis "$9"
  shown "$n: wall time" s "$(scaled 1 "$(json "$n" wall_seconds)")" "$8" "000 tab. 7, MATLAB"
}
for load in "" traction_22_; do # the traction that the source's plate felt, and the one that it prints
  plate ${load:-uniform_}4000 6.05 "22.5 to 23.5" 67.0 "26 to 27" "11 to 12" 2062 5294 1.0e-3 4000
  plate ${load:-uniform_}16000 6.00 "21 to 22" 65.5 "34.5 to 35.5" "15 to 16" 1803 34090 5.0e-4 16000
  plate ${load}adaptive 5.75 "22.0 to 22.5" 64.5 "34.5 to 35.5" "21 to 22" 1750 12813 5.0e-4 6429
done
moved() { kept "$1: displacement beside the notch" awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i }
  END { print $k["displacement_y"] }' "$runs/$1/probes.csv"; }
for n in uniform_4000 uniform_16000; do
  row "displacement beside the notch: adaptive over $n" 1 "$(calc "$(moved adaptive) / $(moved $n)")" "a little less" \
    "000 fig. 63" 0.9 1
done
row "Rayleigh speed" m/s "$(scaled 1 "$rayleigh")" 3058 "(2 - c2/cs2)^2 = 4 ..., plane stress" 3057 3059
shown "experiment: top speed" m/s "" 1580 "Bowden et al. 1967, in 000"
# Freund 1990: K = 2 p/(1 - nu) sqrt(c_d t (1 - 2 nu)/pi). t starts when both waves have met at the notch; p is twice
# the traction.
for s in 22 13.442; do
  n=uniform_16000; [ $s = 22 ] && n=traction_22_16000
  exact=$(awk -v s=$s 'BEGIN { E = 72e9; rho = 2440; G = 135; nu = 0.25; pi = atan2(0, -1)
    c = sqrt(E / rho / (1 - 1 / 9)); r = sqrt(E * G) * (1 - nu) / (4 * s * 1e6)
    printf "%.4g", 1e6 * (0.02 / c + pi * r * r / (c * (1 - 2 * nu))) }')
  row "traction $s MPa, 16000: initiation" us "$(scaled 1e6 "$(of $n "start of growth: first broken bond, t")")" \
    "$exact" "Freund's half-infinite crack" "$(scaled 0.95 "$exact")" "$(scaled 1.05 "$exact")"
done
[ ! "$again" ] || { finish; exit; }
{
  echo "choice, particles, initiation us, branches seen us, ways meet mm, undamaged between from mm, angle first deg," \
    "angle last deg, top speed end to end m/s, top speed m/s, released over G0"
  for n in traction_22 traction_12 traction_11 uniform ramp no_correction ramp_no_correction load_over_horizon \
    half_step; do
    for grid in 4000 16000 64000; do
      r=${n}_$grid
      [ -d "$runs/$r" ] || continue
      echo "$n, $grid, $(scaled 1e6 "$(of "$r" "start of growth: first broken bond, t")")," \
        "$(scaled 1e6 "$(of "$r" "branching: fronts apart from then on, t")")," \
        "$(scaled 1e3 "$(meet "$r" $axis $reach)"), $(scaled 1e3 "$(of "$r" "branching, x")")," \
        "$(of "$r" "angle of the branch to the left, at first")," \
        "$(of "$r" "angle of the branch to the left, at last")," \
        "$(top "$r" 2.0e-6), $(of "$r" "top speed of the tip")," \
        "$(of "$r" "energy released over the new area, over G0")"
    done
  done
} >"$out/sensitivity.csv"
for n in {adaptive,uniform_16000,uniform_4000}/{damage,displacement_y}; do
  m=${n%/*}; cp "$runs/$m/post/pictures/${n#*/}.png" "$out/${n#*/}_${m#uniform_}.png"; done
cp "$runs/compared/plots/crack_speed.png" "$out/crack_speed.png"
if command -v gnuplot >/dev/null; then
  gnuplot -e "set terminal pngcairo size 900,560; set output '$out/notch_displacement.png'; set datafile separator ','; \
    set xlabel 't, us'; set ylabel 'displacement above the tip of the notch, mm'; set key top left; \
    plot for [n in 'uniform_4000 uniform_16000 adaptive'] for [c in 'x y'] '$runs/'.n.'/probes.csv' every ::2 \
      using (1e6*\$2):(1e3*(c eq 'x' ? \$6 : \$7)) with lines lw 1.5 title n.', '.c noenhanced"
fi
finish
