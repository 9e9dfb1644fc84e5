#!/usr/bin/env bash
# Writes results/ from the runs' folders: series, plots, pictures, wall times, and summary.csv with the thesis's numbers
# beside ours, for each load.
# usage: cases/porous_channel/collect.sh RUNS
#        cases/porous_channel/collect.sh --summary     judges the series in results/ again
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../common.sh"
runs=$1 out=$(dirname "$0")/results again=
[ "$runs" != --summary ] || again=yes
mkdir -p "$out"
column() { # column NAME first|last FILE FROM: a value of the first sample from step FROM on, or of the last sample
  awk -F, -v name="$1" -v which="$2" -v from="$4" '
    NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i }
    NR > 2 && $1 >= from { if (!seen++) first = $c; last = $c } END { print which == "first" ? first : last }' "$3"
}
digits=6
summary_begin "$out/summary.csv"
start=$(awk '/name: (flow|settle)/ { gsub(/.*steps: |,.*/, ""); n += $0 } END { print n }' "$(dirname "$0")/s1.yaml")
flow=$(sed -n 's/.*name: flow, steps: \([0-9]*\).*/\1/p' "$(dirname "$0")/s1.yaml")
p0=10
particles=$(kept particles number "$runs/probe/s1/run.json" particles)
row "particles" 1 "$particles" 54662 "001 ch. 5" 53569 55755

# S1 is intact, S2 partly broken, S3 crushed (001: ch. 6: without, with partial, with total fracture). A share of broken
# bonds says which: below 0.001, from there to a tenth, more than a tenth. The largest fragment says it too: in a block
# that is partly broken it holds half of the particles or more, in a crushed one less. So do the flow's losses: flat is
# within 2 %, S2 falls by more, S3 by more than S2.
judge() { # judge LOAD
  local load=$1 s fall fell=0.02 total largest
  before() { column "$1" first "$out/series_${load}_s1.csv" "$start"; }
  after() { column "$2" last "$out/series_${load}_$1.csv" "$start"; } # after RUN COLUMN
  row "$load: dp/p0 at the end of the flow's stage" 1 \
    "$(calc "$(column dp first "$out/series_${load}_s1.csv" "$flow") / $p0")" 190 "001 sec. 6.4.1" 142.5 237.5
  shown "$load: dp/p0 before fracture" 1 "$(calc "$(before dp) / $p0")" "about 190" "001 sec. 6.4.1"
  row "$load: porosity before fracture" 1 "$(before porosity)" "0.72 to 0.73" "from 54662 particles" 0.72 0.73
  shown "$load: permeability before fracture" m2 "$(before permeability)" 3.947e-6 "from dp/p0 = 190"
  for s in s1 s2 s3; do
    fall=$(calc "($(before dp) - $(after $s dp)) / $(before dp)")
    total=$(calc "$(after $s bonds_broken) / ($(after $s bonds_broken) + $(after $s bonds_intact))")
    largest=$(calc "$(after $s largest_fragment) / $particles")
    shown "$load, $s: dp/p0 at the end" 1 "$(calc "$(after $s dp) / $p0")" "" ""
    shown "$load, $s: porosity at the end" 1 "$(after $s porosity)" "" ""
    shown "$load, $s: permeability at the end" m2 "$(after $s permeability)" "" ""
    shown "$load, $s: bonds broken" 1 "$(after $s bonds_broken)" "" ""
    shown "$load, $s: fragments" 1 "$(after $s fragments)" "" ""
    case $s in
    s1) row "$load, s1: share of bonds broken" 1 "$total" "intact" "001 sec. 6.3" 0 1e-3
      row "$load, s1: fragments beside the block" 1 "$(calc "$(after s1 fragments) - 1")" 0 "001 sec. 6.3" 0 0
      row "$load, s1: relative fall of dp" 1 "$fall" "flat" "001 fig. 6.6" -0.02 0.02 ;;
    s2) row "$load, s2: share of bonds broken" 1 "$total" "partly broken" "001 sec. 6.3" 1e-3 0.1
      row "$load, s2: share of particles in the largest fragment" 1 "$largest" "partly broken" "001 sec. 6.3" 0.5 1
      row "$load, s2: relative fall of dp" 1 "$fall" "falls" "001 fig. 6.6" "$fell" 1
      fell=$(calc "($fall > $fell ? $fall : $fell)") ;;
    s3) row "$load, s3: share of bonds broken" 1 "$total" "crushed" "001 sec. 6.3" 0.1 1
      row "$load, s3: share of particles in the largest fragment" 1 "$largest" "crushed" "001 sec. 6.3" 0 0.5
      row "$load, s3: fragments" 1 "$(after s3 fragments)" "many" "001 sec. 6.3" 10
      row "$load, s3: relative fall of dp" 1 "$fall" "falls" "001 fig. 6.6; more than s2's: ours" "$fell" 1 ;;
    esac
  done
}
for load in probe reaction; do
  [ "$again" ] || for s in s1 s2 s3; do cp "$runs/$load/$s/series.csv" "$out/series_${load}_$s.csv"; done
  judge $load
done

# Bonds that soften, on 128 cells and on 192 (run_study.sh). The same crack takes a share of bonds that goes with the
# horizon, so their area is judged too.
tables=$out
over() { calc "$(cell study_softening value bilinear 128 "$1") / $(cell study_softening value bilinear 192 "$1")"; }
if [ -f "$tables/study_softening.csv" ]; then
  row "softening, 128 over 192 cells: time of the first thousandth of bonds" 1 "$(over 'one in a thousand bonds')" 1 \
    "the finer grid" 0.9 1.1
  row "softening, 128 over 192 cells: share of bonds broken" 1 "$(over 'share broken')" 1 "the finer grid" 0.9 1.1
  row "softening, 128 over 192 cells: time of 0.7 cm2 of cracks" 1 "$(over '0.7 cm2 broken')" 1 \
    "the finer grid" 0.9 1.1
  row "softening, 128 over 192 cells: area of cracks" 1 "$(over 'area broken')" 1 "the finer grid" 0.9 1.1
fi
[ ! "$again" ] || { "$of_misses/statements.sh"; finish; exit; }

keep() { [ ! -f "$1" ] || cp "$1" "$2"; } # keep FILE TO
for load in probe reaction; do
  for s in s1 s2 s3; do
    from=$runs/$load/$s/post
    for view in damage_back damage_section; do keep "$from/pictures/$view.png" "$out/${load}_${s}_$view.png"; done
    for pdf in pdf_strain pdf_stress; do
      keep "$from/$pdf.csv" "$out/${load}_${s}_$pdf.csv"
      keep "$from/plots/$pdf.png" "$out/${load}_${s}_$pdf.png"
    done
  done
  [ $load = probe ] || for view in flow_lines slice_z_speed; do
    keep "$runs/$load/s3/post/pictures/$view.png" "$out/${load}_s3_$view.png"
  done
  from=$runs/$load/settled/post
  keep "$from/plots/pressure.png" "$out/${load}_pressure.png"
  [ $load = probe ] || {
    keep "$from/pictures/slice_z_speed.png" "$out/${load}_settled_speed.png"
    keep "$from/pictures/slice_z_pressure.png" "$out/${load}_settled_pressure.png"
    keep "$from/pictures/displacement_back.png" "$out/${load}_settled_displacement.png"
  }
  for p in pressure_drop porosity permeability bonds_broken fragments energy pdf_strain pdf_stress; do
    keep "$runs/$load/compared/plots/$p.png" "$out/${load}_$p.png"
  done
done
{
  echo "run, part, seconds"
  for load in probe reaction; do
    for s in s1 s2 s3; do
      sed -n '/"wall_seconds_by_part"/,/}/s/ *"\([a-z]*\)": \([0-9.e+-]*\),*/'"$load $s"', \1, \2/p' \
        "$runs/$load/$s/run.json"
      echo "$load $s, all, $(number "$runs/$load/$s/run.json" wall_seconds)"
    done
  done
} >"$out/wall_time.csv"
{
  echo "quantity, value"
  echo "processor, $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"
  echo "ranks, $(number "$runs/probe/s1/run.json" ranks)"
  for k in version revision compiler flags mpi hdf5 fftw; do echo "$k, \"$(text "$runs/probe/s1/run.json" $k)\""; done
} >"$out/machine.csv"
"$of_misses/statements.sh" && finish
