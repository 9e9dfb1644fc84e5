#!/usr/bin/env bash
# Moduli of a bar in uniaxial strain and in uniaxial stress, compared with those of its lattice.
# usage: cases/verification/bar/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
lattice() { awk -v m="$1" -f "$here/../lattice.awk" | awk -v name="$2" '$1 == name { print $2 }'; }
study study_column
for m in 2 3 4; do
  near "m = $m: uniaxial strain: stress over strain" E "$(cell study_column value relaxed "m = $m" modulus)" \
    "$(lattice $m c11)" "C11 of the lattice" 1e-5
done
if [ "$quick" ]; then widths="6 12" wide=study; else widths="6 12 24" wide=study_wide; fi
study $wide
for m in 2 3 4; do
  for surface in corrected uncorrected; do
    for width in $widths; do
      shown "m = $m: $width spacings across $surface: modulus" E \
        "$(cell $wide value "m = $m $surface" "$width" modulus)" "$(lattice $m e100)" "E of the lattice along [100]"
    done
  done
done
finish
