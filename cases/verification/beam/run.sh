#!/usr/bin/env bash
# Deflection, bending stiffness and first frequency of cantilevers, compared with Timoshenko's beam.
# usage: cases/verification/beam/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
e=$(awk -v m=3 -f "$here/../lattice.awk" | awk '$1 == "e100" { print $2 }')
# beams STUDY WHAT LEVELS...
beams() {
  local name=$1 what=$2 surface level where judge
  shift 2
  study "$name"
  for surface in corrected uncorrected; do
    for level in "$@"; do
      where="$what: height x slenderness $level $surface"
      judge=(shown)
      case "$what $surface $level" in
        "clamped corrected 8 x 5") judge=(near 0.06) ;;
        "clamped corrected 16 x 5") judge=(near 0.03) ;;
      esac
      "${judge[0]}" "$where: deflection over Timoshenko's" 1 "$(cell "$name" value $surface "$level" deflection)" 1 \
        "E and G of the material" "${judge[@]:1}"
      shown "$where: deflection over Timoshenko's, lattice" 1 \
        "$(cell "$name" value $surface "$level" 'deflection of the lattice')" 1 "E and G of the lattice"
      shown "$where: bending stiffness over E I" 1 "$(cell "$name" value $surface "$level" stiffness)" "$e" \
        "E of the lattice over the material's"
    done
  done
}
if [ "$quick" ]; then
  beams study clamped "6 x 5" "8 x 5"
  beams study_mirror "back to back" "6 x 5"
  name=study_frequency heights="6"
else
  beams study_fine clamped "6 x 5" "8 x 5" "16 x 5" "6 x 10"
  beams study_mirror_fine "back to back" "6 x 5" "8 x 5"
  name=study_frequency_fine heights="6 8"
fi
study $name
for surface in corrected uncorrected; do
  for height in $heights; do
    judge=(shown)
    [ "$surface $height" != "corrected 8" ] || judge=(near 0.06)
    "${judge[0]}" "let go: height x slenderness $height x 5 $surface: first frequency over Timoshenko's" 1 \
      "$(cell $name value $surface "$height x 5" frequency)" 1 "E and G of the material" "${judge[@]:1}"
  done
done
finish
