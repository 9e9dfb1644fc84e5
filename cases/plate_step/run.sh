#!/usr/bin/env bash
# Runs the models and writes results/: summary.csv with the thesis's numbers beside ours, the energies, their plot.
# usage: cases/plate_step/run.sh [FRANA [RUNS [RESULTS]]]
#        cases/plate_step/run.sh --summary [RESULTS]     runs nothing: judges the numbers of measured.csv again
set -euo pipefail
# shellcheck source=cases/common.sh
. "$(dirname "$0")/../common.sh"
here=$(cd "$(dirname "$0")" && pwd)
if [ "${1-}" = --summary ]; then
  again=yes frana='' runs='' out=${2:-$here/results}
else
  again='' frana=${1:-build/frana} runs=${2:-runs/plate_step} out=${3:-$here/results}
  mkdir -p "$runs" "$out"
fi

one=(--set solid.horizons=one_sided) none=(--set 'solid.refinement={from: 1}') # none: refined after 1 s, that is never
# one particle and its family, 7 x 7 mm, instead of a row of them
patch=(--set 'solid.refinement.start=[{low: [0.0169, 0.0199], high: [0.0231, 0.0201], level: 1},
  {low: [0.0179, 0.0179], high: [0.0221, 0.0221], level: 1},
  {low: [0.0199, 0.0169], high: [0.0201, 0.0231], level: 1}]')
# the supported rows are three as well, in a plate two fine rows shorter
fine=(--set solid.spacing=5.0e-4 --set solid.bodies.plate.high='[0.04, 0.041]')
run() { # run NAME options...: runs the step load, and the plate at rest under the same load
  local name=$1
  [ ! "$again" ] || return 0
  shift
  rm -rf "${runs:?}/$name" "${runs:?}/${name}_rest"
  "$frana" run "$here/scene.yaml" --out "$runs/$name" --quiet "$@"
  "$frana" run "$here/scene.yaml" --out "$runs/${name}_rest" --quiet "$@" \
    --set 'stages=[{name: rest, relax: true, steps: 4000}]'
}
run uniform "${none[@]}"
run uniform_fine "${none[@]}" "${fine[@]}"
run b "${one[@]}"
run b_corrected "${one[@]}" --set solid.refinement.interface=corrected
run dual
run dual_kept --set solid.refinement.horizon=kept
run patch_b "${one[@]}" "${patch[@]}"
run patch_b_corrected "${one[@]}" --set solid.refinement.interface=corrected "${patch[@]}"
run patch_dual "${patch[@]}"

# The energy error of the coupling, %: largest |kinetic + strain energy - work of load and support| over the largest
# energy.
unbalanced() {
  awk -F, "$names"' { e = $k["e_kinetic_solid"] + $k["e_strain"]; d = e - $k["work_load"] - $k["e_constraint"]
      if (e > top) top = e; if (d < 0) d = -d; if (d > most) most = d }
    END { print 100 * most / top }' "$runs/$1/series.csv"
}
# Largest difference between the total energy and that on the uniform coarse grid, over the largest energy, %.
deviation() {
  awk -F, "$names"' { e = $k["e_kinetic_solid"] + $k["e_strain"]; s = $k["step"] }
    FILENAME == ARGV[1] { uniform[s] = e; if (e > top) top = e; next }
    { d = uniform[s] - e; if (d * d > most * most) most = d }
    END { print 100 * most / top }' "$runs/uniform/series.csv" "$runs/$1/series.csv"
}
# Greatest energy density and greatest displacement along the load of a particle, minus those on the uniform coarse
# grid, %.
peak() { # peak NAME PROBE COLUMN
  awk -F, -v p="$2" -v c="$3" "$names"' $k["probe"] != p { next } { v = $k[c]; if (v < 0) v = -v }
    FILENAME == ARGV[1] { if (v > uniform) uniform = v; next }
    { if (v > here) here = v }
    END { print 100 * (here / uniform - 1) }' "$runs/uniform/probes.csv" "$runs/$1/probes.csv"
}
# Displacement of the loaded edge at rest, minus that on the uniform coarse grid, %.
longer() {
  awk -F, "$names"' $k["probe"] == 2 { if (FILENAME == ARGV[1]) uniform = $k["displacement_y"];
    else here = $k["displacement_y"] }
    END { print 100 * (here / uniform - 1) }' "$runs/uniform_rest/probes.csv" "$runs/$1_rest/probes.csv"
}

digits=4
summary_begin "$out/summary.csv"
shown "particles: uniform" 1 "$(json uniform particles)" "" ""
shown "particles: band" 1 "$(json dual particles)" "" ""
shown "particles: patch" 1 "$(json patch_dual particles)" "" ""
made_or_lost() { kept "$1: made or lost" unbalanced "$1"; }
less() { kept "$1: less than uniform" deviation "$1"; }
rest() { shown "$1: at rest longer than uniform coarse" % "$(kept "$2: at rest longer" longer "$2")" "" ""; }
# one_sided LABEL NAME LOSS: the rows of a model of 000, whose energy falls short by LOSS: ours must be a loss too
one_sided() {
  shown "$1: energy made or lost" % "$(made_or_lost "$2")" "" ""
  row "$1: energy less than uniform coarse's" % "$(less "$2")" "$3" "000 fig. 48: lost" 0 "$3"
  rest "$1" "$2"
}
conserving() { # conserving LABEL NAME: the rows of a model that conserves energy
  at_most "$1: energy made or lost" % "$(made_or_lost "$2")" 0 "no loss" 0.02
  at_most "$1: energy less than uniform coarse's" % "$(less "$2")" 0 "no loss" 1
  rest "$1" "$2"
}
at_most "uniform coarse: energy made or lost" % "$(made_or_lost uniform)" 0 exact 0.02
at_most "uniform fine: energy made or lost" % "$(made_or_lost uniform_fine)" 0 exact 0.02
shown "uniform fine: energy less than uniform coarse's" % "$(less uniform_fine)" "" ""
rest "uniform fine" uniform_fine
one_sided "band; B" b 7.15
one_sided "band; B corrected" b_corrected 13.65
conserving "band; dual horizon" dual
conserving "band; dual horizon kept" dual_kept
one_sided "patch; B" patch_b 7.15
one_sided "patch; B corrected" patch_b_corrected 13.65
conserving "patch; dual horizon" patch_dual
top() { shown "$1: greatest $2" % "$(kept "$1: greatest $2" peak "$1" "$3" "$4")" "" ""; }
for m in uniform_fine b b_corrected dual dual_kept patch_dual; do
  top $m "displacement at (0.02 0.02)" 0 displacement_y
  top $m "energy density at (0.02 0.02)" 0 energy_density
  top $m "energy density at the interface" 1 energy_density
done
[ ! "$again" ] || { finish; exit; }
{
  echo "t,uniform,uniform_fine,b,b_corrected,dual,dual_kept"
  echo "#s,J,J,J,J,J,J"
  files=()
  for m in uniform uniform_fine b b_corrected dual dual_kept; do files+=("$runs/$m/series.csv"); done
  awk -F, 'FNR == 1 { file++; delete k; for (i = 1; i <= NF; i++) k[$i] = i } FNR <= 2 { next }
    file == 1 { step[++n] = $k["step"]; line[$k["step"]] = $k["t"] }
    { line[$k["step"]] = line[$k["step"]] sprintf(",%.8g", $k["e_kinetic_solid"] + $k["e_strain"]) }
    END { for (i = 1; i <= n; i++) print line[step[i]] }' "${files[@]}"
} >"$out/energy.csv"
if command -v gnuplot >/dev/null; then
  gnuplot <<GP
set terminal pngcairo size 900,560
set output "$out/energy.png"
set datafile separator ","
set xlabel "t, s"
set ylabel "(energy of the uniform coarse grid - energy)/its largest, %"
stats "$out/energy.csv" every ::2 using 2 nooutput
plot for [c=4:7] "$out/energy.csv" every ::2 using 1:(100*(column(2)-column(c))/STATS_max) \
  with lines lw 1.5 title word("B B-corrected dual dual-kept", c-3)
GP
fi
finish
