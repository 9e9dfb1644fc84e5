#!/usr/bin/env bash
# A rigid sphere hits a brittle disc: LAMMPS's energies on the lattice; the fracture pattern's azimuthal modes, damage
# and pieces on the lattice, the lattice turned, hexagonal, perturbed and centroidal points.
# usage: cases/verification/impact_disc/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

# go NAME SCENE [WORD...]: runs a scene once; its processor time goes to NAME.seconds
go() {
  local name=$1 scene=$2 TIMEFORMAT=%U
  shift 2
  [ ! "$again" ] || return 0
  ! is_done "$runs/$name" || [ "$runs/$name/run.json" -ot "$frana" ] || return 0
  rm -rf "${runs:?}/$name"
  { time "$frana" run "$here/$scene.yaml" --out "$runs/$name" "$@" >"$runs/$name.log" 2>&1; } 2>"$runs/$name.seconds" ||
    { cat "$runs/$name.log" >&2; return 1; }
}
# modes FILE WHAT N STEP, pieces NAME WHAT: a number of modes.csv (modes.awk), of NAME's pieces (pieces.awk)
modes() { awk -F, -v what="$2" -v of="$3" -v step="$4" -f "$here/modes.awk" "$1"; }
of() { kept "$1: $2 $3 at $4" modes "$runs/$1/modes.csv" "$2" "$3" "$4"; }
pieces_of() { awk -F, -v what="$2" -v up=velocity_y -f "$here/pieces.awk" "$runs/$1/fragments.csv"; }
pieces() { kept "$1: $2" pieces_of "$@"; }
# sampled NAME COLUMN STEP: of series.csv; energy NAME STEP: as LAMMPS counts it, with the bonds that break in the step
sampled() { awk -F, -v c="$2" -v s="$3" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 && $1 == s { print $at[c] }' "$runs/$1/series.csv"; }
energy() { awk -F, -v s="$2" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 && $1 == s { printf "%.15g\n", $at["e_strain"] + $at["e_fracture"] - before }
  NR > 2 { before = $at["e_fracture"] }' "$runs/$1/series.csv"; }
# theirs COLUMN STEP: of LAMMPS's run
theirs() { awk -F, -v c="$1" -v s="$2" '$1 == s { print $c }' "$here/lammps.csv"; }

# The same particles and bonds, and the energies until LAMMPS's short-range forces act
go start scene --set stages.impact.steps=160 --set output.series_every=1 --set output.fields_every=0 \
  --set output.fragments=false
row "particles" 1 "$(json start particles)" 103110 "LAMMPS, Howto_peri" 103110 103110
row "directed bonds" 1 "$(json start directed_bonds)" 10009800 LAMMPS 10009800 10009800
for step in 20 40 60 80 100 120 140 160; do
  near "step $step: energy of the bonds" J "$(kept "e_strain at $step" energy start $step)" "$(theirs 2 $step)" \
    LAMMPS 1e-8
  near "step $step: kinetic energy" J "$(kept "e_kinetic at $step" sampled start e_kinetic_solid $step)" \
    "$(theirs 3 $step)" LAMMPS 1e-8
done
[ "$quick" ] && { finish; exit; }

# The whole disc
round="{shape: cylinder, centre: [0.04, 0.01375, 0.04], radius: 0.0369802, length: 0.003, axis: y"
go lattice scene
go centroidal scene --set "solid.bodies=[$round, arrangement: {kind: centroidal, seed: 1}}]"
for step in 300 600; do
  near "lattice, step $step: kinetic energy" J \
    "$(kept "lattice: e_kinetic at $step" sampled lattice e_kinetic_solid $step)" "$(theirs 3 $step)" LAMMPS 0.01
  near "lattice, step $step: mean damage" 1 "$(kept "lattice: damage at $step" sampled lattice damage_mean $step)" \
    "$(theirs 4 $step)" LAMMPS 0.01
  row "lattice, step $step: share of modes 4, 8 and 12" 1 "$(of lattice fold 4 $step)" \
    "$(modes "$here/lammps_modes.csv" fold 4 $step)" LAMMPS 0.99 1
  for mode in 4 8 12; do
    shown "lattice, step $step: amplitude of mode $mode" 1 "$(of lattice amplitude $mode $step)" \
      "$(modes "$here/lammps_modes.csv" amplitude $mode $step)" LAMMPS
  done
  shown "centroidal, step $step: share of modes 4, 8 and 12" 1 "$(of centroidal fold 4 $step)" 0.25 "3 of 12 modes"
  for mode in 4 8 12; do
    shown "centroidal, step $step: amplitude of mode $mode" 1 "$(of centroidal amplitude $mode $step)" "" ""
  done
  shown "centroidal, step $step: mean damage" 1 \
    "$(kept "centroidal: damage at $step" sampled centroidal damage_mean $step)" "" ""
done
for name in lattice centroidal; do
  shown "$name: pieces" 1 "$(pieces $name pieces)" "" ""
  shown "$name: mass of the largest piece" 1 "$(pieces $name largest)" "" "over the disc's"
  shown "$name: mass in pieces of ten particles or fewer" 1 "$(pieces $name dust)" "" "over the disc's"
  shown "$name: mass that flies back at more than 10 m/s" 1 "$(pieces $name back)" "" "over the disc's"
  shown "$name: processor time of 600 steps and the start" s "$(kept "$name: seconds" cat "$runs/$name.seconds")" "" \
    "one core that others use too"
done

# A small disc: ensembles, and points with axes
study study_axes
study study_seeds
# one level a method: no curves of error against run time
[ "$again" ] || { rm -f "$out"/study_*.png "$out"/study_*.md && sed -i '/^# advice on/d' "$out"/study_*.csv; }
[ "$again" ] || awk -v angle=20 -f "$here/turned.awk" >"$runs/turned.txt"
go turned small --set "solid.bodies=[{shape: points, file: $(realpath -m "$runs/turned.txt")}]"
straight=$runs/runs/study_axes/lattice/small/1
# turn STEP: by how much mode 8 of the turned lattice stands at another angle, between 0 and 45 degrees
turn() {
  calc "($(modes "$runs/turned/modes.csv" angle 8 "$1") - $(modes "$straight/modes.csv" angle 8 "$1") + 90) % 45"
}
for step in 300 400; do
  row "small lattice, step $step: share of modes 4, 8 and 12" 1 "$(cell study_axes value lattice small fold4_$step)" 1 \
    "four-fold symmetry" 0.99 1
  row "small lattice turned by 20 degrees, step $step: share of modes 4, 8 and 12" 1 "$(of turned fold 4 $step)" 1 \
    "four-fold symmetry" 0.95 1
  row "small lattice turned by 20 degrees, step $step: its mode 8 is turned by" degrees \
    "$(kept "turned: angle at $step" turn $step)" 20 "as the lattice" 19 21
  row "small, ten seeds of centroidal points, step $step: mean share of modes 4, 8 and 12" 1 \
    "$(cell study_seeds value centroidal small fold4_$step)" 0.25 "3 of 12 modes" 0.1 0.4
  for method in lattice hexagonal; do
    shown "small, $method, step $step: share of modes 6 and 12" 1 \
      "$(cell study_axes value $method small fold6_$step)" 0.1667 "2 of 12 modes"
  done
  for method in centroidal perturbed; do
    for quantity in value value_spread; do
      name=$([ $quantity = value ] && echo "mean" || echo "deviation")
      shown "small, $method, step $step: share of modes 4, 8 and 12, $name" 1 \
        "$(cell study_seeds $quantity $method small fold4_$step)" 0.25 "3 of 12 modes"
      shown "small, $method, step $step: amplitude of mode 8, $name" 1 \
        "$(cell study_seeds $quantity $method small mode8_$step)" \
        "$(cell study_axes value lattice small mode8_$step)" "the lattice's"
    done
  done
done
[ "$again" ] || "$here/draw.sh" "$runs" "$out"
finish
