#!/usr/bin/env bash
# Moduli of a bar in uniaxial strain and of bars, plates and strips in uniaxial stress, compared with those of their
# lattice, for each surface correction.
# usage: cases/verification/bar/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
lattice() { awk -v m="$1" -f "$here/../lattice.awk" | awk -v name="$2" '$1 == name { print $2 }'; }
study study_column
for m in 2 3 4; do
  near "m = $m: uniaxial strain: stress over strain" E "$(cell study_column value relaxed "m = $m" modulus)" \
    "$(lattice $m c11)" "C11 of the lattice" 1e-5
done
# walls STUDY WHAT MODULUS SOURCE WIDTHS...: the surface correction by energy is judged, the others are shown
walls() {
  local name=$1 what=$2 modulus=$3 source=$4 m surface width
  shift 4
  study "$name"
  for m in 2 3 4; do
    exact=$(lattice $m "$modulus")
    for surface in energy volume none; do
      for width in "$@"; do
        judge=(shown)
        [ $surface != energy ] || judge=(near 0.02)
        "${judge[0]}" "$what, m = $m, surface correction $surface: $width spacings across: modulus" E \
          "$(cell "$name" value "m = $m $surface" "$width" modulus)" "$exact" "$source" "${judge[@]:1}"
      done
    done
  done
}
if [ "$quick" ]; then
  walls study bar e100 "E of the lattice along [100]" 6 12
else
  walls study_wide bar e100 "E of the lattice along [100]" 6 8 12 16 24
  walls study_plate plate plate100 "E/(1 - nu^2) of the lattice along [100]" 6 8 12 16 24
  walls study_strip strip plane_e100 "E of the square lattice along [10]" 6 8 12 16 24
fi
finish
