#!/usr/bin/env bash
# Particles, bonds and energies of an oscillating cylinder and of the example's impact, compared with LAMMPS.
# usage: cases/verification/lammps_example/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
lattice() {
  "$frana" check "$here/lattice.yaml" | awk '$1 == "solid" && $3 == "particles" { print $2, 2 * $(NF - 1) }'
}
read -r particles bonds <<<"$(kept lattice lattice)"
row "lattice: particles" 1 "$particles" 3487 "LAMMPS log.27Nov18.peri.pmb" 3487 3487
row "lattice: directed bonds" 1 "$bonds" 335966 "LAMMPS log.27Nov18.peri.pmb" 335966 335966
# The same sites as cells of a tenth of the spacing. The horizon cuts none of them, so the weights of LAMMPS and of
# frana are all 1.
[ "$again" ] || awk 'BEGIN { for (j = 0; j <= 10; j++) for (k = -10; k <= 10; k++) for (i = -10; i <= 10; i++)
  if (i * i + k * k <= 100)
    printf "%.6f %.6f %.6f 1.25e-13\n", 0.006 + i * 5e-4, 0.001 + j * 5e-4, 0.006 + k * 5e-4 }' >"$runs/cylinder.txt"
[ "$again" ] || {
  rm -rf "$runs/wave"
  "$frana" run "$here/scene.yaml" --out "$runs/wave" --set "solid.bodies[0].file=$(realpath "$runs/cylinder.txt")" \
    >"$runs/wave.log" 2>&1 ||
    { cat "$runs/wave.log" >&2; exit 1; }
}
directed() { awk -F'[:,]' '/directed_bonds/ { print $2 + 0 }' "$runs/wave/run.json"; }
row "points: directed bonds" 1 "$(kept "points: directed bonds" directed)" 335966 "LAMMPS" 335966 335966
# energy COLUMN STEP: an energy of frana's run; theirs COLUMN STEP: of LAMMPS's run
energy() { awk -F, -v c="$1" -v s="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == c) at = i } NR > 2 && $1 == s {
  print $at }' "$runs/wave/series.csv"; }
theirs() { awk -F, -v c="$1" -v s="$2" '$1 == s { print $c }' "$here/lammps.csv"; }
for step in 20 40 60 80 100; do
  near "step $step: energy of the bonds" J "$(kept "e_strain at $step" energy e_strain $step)" \
    "$(theirs 2 $step)" "LAMMPS" 1e-11
  near "step $step: kinetic energy" J "$(kept "e_kinetic_solid at $step" energy e_kinetic_solid $step)" \
    "$(theirs 3 $step)" "LAMMPS" 1e-11
done
# The example's impact: energies of LAMMPS's own run, and those that its log of 27 Nov 2018 prints, which are sums of
# energies per volume.
[ "$again" ] || {
  rm -rf "$runs/impact"
  "$frana" run "$here/impact.yaml" --out "$runs/impact" >"$runs/impact.log" 2>&1 ||
    { cat "$runs/impact.log" >&2; exit 1; }
}
# struck COLUMN STEP FACTOR: a number of frana's run times the factor. LAMMPS's energy has the bonds that break in the
# step, as its forces do; here that is what the step has added to e_fracture. log COLUMN STEP: of LAMMPS's run
struck() { awk -F, -v c="$1" -v s="$2" -v f="$3" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 && $1 == s { x = $at[c] + (c == "e_strain" ? $at["e_fracture"] - before : 0); printf "%.15g\n", x * f }
  NR > 2 { before = $at["e_fracture"] }' "$runs/impact/series.csv"; }
log() { awk -F, -v c="$1" -v s="$2" '$1 == s { print $c }' "$here/impact.csv"; }
impact_bonds() { awk -F'[:,]' '/directed_bonds/ { print $2 + 0 }' "$runs/impact/run.json"; }
row "impact: directed bonds" 1 "$(kept "impact: directed bonds" impact_bonds)" 335966 "LAMMPS" 335966 335966
for step in 20 40 60 80 100 120 140 160 180 200; do
  near "impact, step $step: energy of the bonds" J "$(kept "impact: e_strain at $step" struck e_strain $step 1)" \
    "$(log 2 $step)" "LAMMPS" 1e-8
  near "impact, step $step: kinetic energy" J \
    "$(kept "impact: e_kinetic_solid at $step" struck e_kinetic_solid $step 1)" \
    "$(log 3 $step)" "LAMMPS" 1e-8
done
total() { awk -v a="$(struck e_strain "$1" 8e9)" -v b="$(struck e_kinetic_solid "$1" 8e9)" \
  'BEGIN { printf "%.15g\n", a + b }'; }
while read -r step pair all; do
  near "impact, step $step: E_pair" J/m3 "$(kept "impact: E_pair at $step" struck e_strain "$step" 8e9)" "$pair" \
    "LAMMPS log.27Nov18.peri.pmb" 1e-3
  near "impact, step $step: TotEng" J/m3 "$(kept "impact: TotEng at $step" total "$step")" "$all" \
    "LAMMPS log.27Nov18.peri.pmb" 1e-3
done <<<"100 552721.8 681881.47
200 3097027.6 1.0091931e8"
finish
