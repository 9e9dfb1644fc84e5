#!/usr/bin/env bash
# Writes results/ from the runs' folders: series, plots, pictures, wall times, and summary.csv with the thesis's numbers
# beside ours.
# usage: cases/porous_channel/collect.sh RUNS
#        cases/porous_channel/collect.sh --summary     judges the series in results/ again
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../common.sh"
runs=$1 out=$(dirname "$0")/results again=
[ "$runs" != --summary ] || again=yes
mkdir -p "$out"
column() { # column NAME first|last FILE: a value of the last stage's first sample, or of the last sample
  awk -F, -v name="$1" -v which="$2" -v from="$4" '
    NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) c = i }
    NR > 2 && $1 >= from { if (!seen++) first = $c; last = $c } END { print which == "first" ? first : last }' "$3"
}
digits=6
summary_begin "$out/summary.csv"
start=$(awk '/name: (flow|settle)/ { gsub(/.*steps: |,.*/, ""); n += $0 } END { print n }' "$(dirname "$0")/s1.yaml")
p0=10
row "particles" 1 "$(kept particles number "$runs/s1/run.json" particles)" 54662 "001 ch. 5" 53569 55755
[ "$again" ] || for s in s1 s2 s3; do cp "$runs/$s/series.csv" "$out/series_$s.csv"; done
before() { column "$1" first "$out/series_s1.csv" "$start"; }
after() { column "$2" last "$out/series_$1.csv" "$start"; } # after RUN COLUMN
# S1 is intact, S2 partly broken, S3 crushed (001: ch. 6: without, with partial, with total fracture). A share of broken
# bonds says which: below 0.001, from there to a tenth, more than a tenth. The largest fragment says it too: in a block
# that is partly broken it holds half of the particles or more, in a crushed one less. So do the flow's losses: flat is
# within 2 %, S2 falls by more, S3 by more than S2.
row "dp/p0 before fracture" 1 "$(calc "$(before dp) / $p0")" 190 "001 sec. 6.4.1" 142.5 237.5
row "porosity before fracture" 1 "$(before porosity)" "0.72 to 0.73" "from 54662 particles" 0.72 0.73
shown "permeability before fracture" m2 "$(before permeability)" 3.947e-6 "from dp/p0 = 190"
fell=0.02
for s in s1 s2 s3; do
  fall=$(calc "($(before dp) - $(after $s dp)) / $(before dp)")
  total=$(calc "$(after $s bonds_broken) / ($(after $s bonds_broken) + $(after $s bonds_intact))")
  largest=$(calc "$(after $s largest_fragment) / $(kept particles number "$runs/s1/run.json" particles)")
  shown "$s: dp/p0 at the end" 1 "$(calc "$(after $s dp) / $p0")" "" ""
  shown "$s: porosity at the end" 1 "$(after $s porosity)" "" ""
  shown "$s: permeability at the end" m2 "$(after $s permeability)" "" ""
  shown "$s: bonds broken" 1 "$(after $s bonds_broken)" "" ""
  shown "$s: fragments" 1 "$(after $s fragments)" "" ""
  case $s in
  s1) row "s1: share of bonds broken" 1 "$total" "intact" "001 sec. 6.3" 0 1e-3
    row "s1: fragments beside the block" 1 "$(calc "$(after s1 fragments) - 1")" 0 "001 sec. 6.3" 0 0
    row "s1: relative fall of dp" 1 "$fall" "flat" "001 fig. 6.6" -0.02 0.02 ;;
  s2) row "s2: share of bonds broken" 1 "$total" "partly broken" "001 sec. 6.3" 1e-3 0.1
    row "s2: share of particles in the largest fragment" 1 "$largest" "partly broken" "001 sec. 6.3" 0.5 1
    row "s2: relative fall of dp" 1 "$fall" "falls" "001 fig. 6.6" "$fell" 1
    fell=$(calc "($fall > $fell ? $fall : $fell)") ;;
  s3) row "s3: share of bonds broken" 1 "$total" "crushed" "001 sec. 6.3" 0.1 1
    row "s3: share of particles in the largest fragment" 1 "$largest" "crushed" "001 sec. 6.3" 0 0.5
    row "s3: fragments" 1 "$(after s3 fragments)" "many" "001 sec. 6.3" 10
    row "s3: relative fall of dp" 1 "$fall" "falls most" "001 fig. 6.6" "$fell" 1 ;;
  esac
done
[ ! "$again" ] || { finish; exit; }
for s in s1 s2 s3; do
  for view in damage_back damage_section; do
    [ -f "$runs/$s/post/pictures/$view.png" ] && cp "$runs/$s/post/pictures/$view.png" "$out/${s}_$view.png"
  done
  for f in pdf_strain.csv pdf_stress.csv; do [ -f "$runs/$s/post/$f" ] && cp "$runs/$s/post/$f" "$out/${s}_$f"; done
  for p in pdf_strain pdf_stress; do [ -f "$runs/$s/post/plots/$p.png" ] && cp "$runs/$s/post/plots/$p.png" \
    "$out/${s}_$p.png"; done
done
[ -f "$runs/s1/post/plots/pressure.png" ] && cp "$runs/s1/post/plots/pressure.png" "$out/pressure.png"
for p in pressure_drop porosity permeability bonds_broken fragments energy pdf_strain pdf_stress; do
  cp "$runs/compared/plots/$p.png" "$out/"
done
{
  echo "run, part, seconds"
  for s in shared s1 s2 s3; do
    [ -f "$runs/$s/run.json" ] || continue # shared: the first two stages, where S1 was stopped behind them and resumed
    sed -n '/"wall_seconds_by_part"/,/}/s/ *"\([a-z]*\)": \([0-9.e+-]*\),*/'$s', \1, \2/p' "$runs/$s/run.json"
    echo "$s, all, $(number "$runs/$s/run.json" wall_seconds)"
  done
} >"$out/wall_time.csv"
{
  echo "quantity, value"
  echo "processor, $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"
  echo "ranks, $(number "$runs/s1/run.json" ranks)"
  for k in version revision compiler flags mpi hdf5 fftw; do echo "$k, \"$(text "$runs/s1/run.json" $k)\""; done
} >"$out/machine.csv"
finish
