#!/usr/bin/env bash
# Deflection, bending stiffness and first frequency of cantilevers, compared with Timoshenko's beam, for each surface
# correction.
# usage: cases/verification/beam/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
lattice() { awk -v m=3 -f "$here/../lattice.awk" | awk -v name="$1" '$1 == name { print $2 }'; }
e=$(lattice e100)
# beams STUDY WHAT MODULUS SURFACES LEVELS...
# Back to back, by energy: deflection and stiffness are judged against the beam of the lattice. A clamp over a horizon
# is softer than a section that is held: clamped, they are shown.
beams() {
  local name=$1 what=$2 modulus=$3 surfaces=$4 surface level where judge
  shift 4
  study "$name"
  for surface in $surfaces; do
    for level in "$@"; do
      where="$what: height x slenderness $level, surface correction $surface"
      judge=(shown)
      [ "${what%% *} $surface" != "back energy" ] || judge=(near 0.03)
      shown "$where: deflection over Timoshenko's" 1 "$(cell "$name" value "$surface" "$level" deflection)" 1 \
        "E and G of the material"
      "${judge[0]}" "$where: deflection over Timoshenko's, lattice" 1 \
        "$(cell "$name" value "$surface" "$level" 'deflection of the lattice')" 1 "E and G of the lattice" \
        "${judge[@]:1}"
      "${judge[0]}" "$where: bending stiffness over E I" 1 "$(cell "$name" value "$surface" "$level" stiffness)" \
        "$modulus" "E of the lattice over the material's" "${judge[@]:1}"
    done
  done
}
# frequencies STUDY WHAT LEVELS...: E of the lattice enters by its root
frequencies() {
  local name=$1 what=$2 surface level where judge
  shift 2
  study "$name"
  for surface in energy volume none; do
    for level in "$@"; do
      judge=(shown)
      [ "${what%% *} $surface" != "back energy" ] || judge=(near 0.03)
      where="$what: height x slenderness $level, surface correction $surface"
      "${judge[0]}" "$where: first frequency over Timoshenko's" 1 \
        "$(cell "$name" value "$surface" "$level" frequency)" 1 "E and G of the material" "${judge[@]:1}"
    done
  done
}
all="energy volume none"
if [ "$quick" ]; then
  beams study clamped "$e" "$all" "6 x 5" "8 x 5"
  beams study_mirror "back to back" "$e" "$all" "6 x 5"
  frequencies study_frequency "let go, clamped" "6 x 5"
else
  beams study_fine clamped "$e" "$all" "6 x 5" "8 x 5" "16 x 5" "6 x 10"
  beams study_mirror_fine "back to back" "$e" "$all" "6 x 5" "8 x 5" "12 x 5" "16 x 5"
  beams study_mirror_24 "back to back" "$e" energy "24 x 5"
  beams study_mirror_plane "back to back, plane stress" "$(lattice plane_e100)" "$all" \
    "6 x 5" "8 x 5" "12 x 5" "16 x 5" "24 x 5"
  frequencies study_frequency_fine "let go, clamped" "6 x 5" "8 x 5"
  frequencies study_mirror_frequency_fine "back to back, let go" "6 x 5" "8 x 5" "12 x 5"
fi
finish
