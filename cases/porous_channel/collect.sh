#!/usr/bin/env bash
# Writes results/ from the runs' folders: series, plots, pictures, wall times, and summary.csv with the thesis's numbers
# beside ours, for each load (gates.yaml).
# usage: cases/porous_channel/collect.sh RUNS
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../common.sh"
runs=$1 out=$(dirname "$0")/results
mkdir -p "$out"
for load in probe reaction; do
  for s in s1 s2 s3; do cp "$runs/$load/$s/series.csv" "$out/series_${load}_$s.csv"; done
done

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
"$(dirname "$0")/../../tools/statements.sh"
"${FRANA:-build/frana}" study "$(dirname "$0")/gates.yaml" --out "$out" --results "$out"
