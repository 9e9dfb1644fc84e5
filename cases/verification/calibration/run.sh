#!/usr/bin/env bash
# frana calibrate: what running and creeping cracks take by direction, where a notch starts, what a smooth bar bears, at
# m = 3, 4, 5, in plane stress and in space, with brittle and with bilinear bonds.
# usage: cases/verification/calibration/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

# calibrated NAME SCENE OPTIONS...: calibrates; runs that this frana has made are not made again
calibrated() {
  local name=$1 scene=$2
  shift 2
  [ ! "$again" ] || return 0
  [ ! -d "$runs/$name" ] || [ -z "$(find "$runs/$name" -name run.json ! -newer "$frana")" ] || rm -rf "${runs:?}/$name"
  "$frana" calibrate "$here/$scene.yaml" --out "$runs/$name" --quiet "$@" >"$runs/$name.log" 2>&1 ||
    { cat "$runs/$name.log" >&2; exit 1; }
}
# number_of NAME MATERIAL QUANTITY DIRECTION: from the table of a calibration
number_of() {
  awk -F, -v m="$2" -v q="$3" -v d="$4" '$1 == m && $2 == q && $3 == d { print $4; found = 1 }
    END { exit !found }' "$runs/$1/calibration.csv"
}
# value NAME MATERIAL QUANTITY [DIRECTION]
value() { kept "$1 $2 $3 ${4-}" number_of "$1" "$2" "$3" "${4-}"; }

if [ "$quick" ]; then
  calibrated plate plate --quick --only bar,running --set 'solid.materials[1].fracture_energy=.inf' \
    --set 'solid.materials[2].fracture_energy=.inf'
  near "plate: m = 3: smooth bar" "E s0" "$(value plate m3 bar_strength)" 1 "s0" 0.05
  near "plate: m = 3: running crack [100]" G0 "$(value plate m3 running_crack '[100]')" 1.189 \
    "cases/verification/fracture_energy" 0.06
  finish
  exit
fi

calibrated plate plate
calibrated soft soft
calibrated space space
for spacing in 1.0e-3 0.5e-3; do
  calibrated "soft_space_$spacing" soft_space --set solid.spacing=$spacing --only bar,creeping
done
calibrated soft_space_0.25e-3 soft_space --set solid.spacing=0.25e-3 --only bar

# brittle plates
for m in 3 4 5; do
  near "plate: m = $m: smooth bar" "E s0" "$(value plate m$m bar_strength)" 1 "s0" 0.05
  judge=(shown)
  [ $m != 3 ] || judge=(near 0.03)
  "${judge[0]}" "plate: m = $m: running crack [100]" G0 "$(value plate m$m running_crack '[100]')" 1.189 \
    "cases/verification/fracture_energy" "${judge[@]:1}"
  for direction in "15 deg" "30 deg" "[110]"; do
    shown "plate: m = $m: running crack $direction" G0 "$(value plate m$m running_crack "$direction")" "" ""
    at_most "plate: m = $m: running crack $direction: its way's angle to the cut" deg \
      "$(value plate m$m running_crack_turns "$direction")" 0 "the cut" 5
  done
  judge=(shown)
  [ $m != 3 ] || judge=(near 0.1)
  "${judge[0]}" "plate: m = $m: creeping crack [100]: work less strain energy" G0 \
    "$(value plate m$m creeping_crack '[100]')" 1.59 "cases/verification/notched_beam" "${judge[@]:1}"
  "${judge[0]}" "plate: m = $m: creeping crack [100]: bonds" G0 "$(value plate m$m creeping_crack_bonds '[100]')" 1.25 \
    "cases/verification/notched_beam" "${judge[@]:1}"
  shown "plate: m = $m: creeping crack [110]: work less strain energy" G0 \
    "$(value plate m$m creeping_crack '[110]')" "" ""
  shown "plate: m = $m: creeping crack [110]: bonds" G0 "$(value plate m$m creeping_crack_bonds '[110]')" "" ""
  shown "plate: m = $m: notch of four horizons: first bond" "Griffith's load" \
    "$(value plate m$m notch_first_bond '[100]')" 1 Griffith
  "${judge[0]}" "plate: m = $m: notch of four horizons: largest load" "Griffith's load" \
    "$(value plate m$m notch_largest_load '[100]')" 1.153 "cases/verification/notched_beam" "${judge[@]:1}"
done

# brittle in space
near "space: smooth bar" "E s0" "$(value space m3 bar_strength)" 1 "s0" 0.05
near "space: running crack [100]" G0 "$(value space m3 running_crack '[100]')" 1.18 \
  "docs/choosing.md, 1.16 to 1.20" 0.05
shown "space: running crack [110]" G0 "$(value space m3 running_crack '[110]')" "" ""
at_most "space: running crack [110]: its way's angle to the cut" deg \
  "$(value space m3 running_crack_turns '[110]')" 0 "the cut" 5
shown "space: creeping crack [100]: work less strain energy" G0 "$(value space m3 creeping_crack '[100]')" "" ""
shown "space: creeping crack [100]: bonds" G0 "$(value space m3 creeping_crack_bonds '[100]')" "" ""
shown "space: notch of four horizons: first bond" "Griffith's load" "$(value space m3 notch_first_bond '[100]')" 1 \
  Griffith
shown "space: notch of four horizons: largest load" "Griffith's load" \
  "$(value space m3 notch_largest_load '[100]')" 1 Griffith

# bilinear in a plate
near "bilinear plate: smooth bar" sigma_t "$(value soft soft bar_strength)" 1 "the given strength" 0.05
for direction in "[100]" "[110]"; do
  near "bilinear plate: creeping crack $direction" G0 "$(value soft soft creeping_crack "$direction")" 1.057 \
    "cases/verification/softening, horizon 0.57 E G0/sigma_t2" 0.03
  shown "bilinear plate: running crack $direction" G0 "$(value soft soft running_crack "$direction")" "" ""
done
shown "bilinear plate: notch of four horizons: largest load" "Griffith's load" \
  "$(value soft soft notch_largest_load '[100]')" 1 Griffith

# bilinear in space, on horizons of 0.6, 0.3 and 0.15 E G0/sigma_t2
finest=$(value soft_space_0.25e-3 soft bar_strength)
for spacing in 1.0e-3 0.5e-3 0.25e-3; do
  strength=$(value soft_space_$spacing soft bar_strength)
  near "bilinear in space: spacing $spacing m: smooth bar" sigma_t "$strength" 1 "the given strength" 0.05
  [ $spacing = 0.25e-3 ] ||
    near "bilinear in space: spacing $spacing m: smooth bar over that of 0.25e-3 m" 1 "$strength" "$finest" \
      "the finest horizon" 0.03
done
finest=$(value soft_space_0.5e-3 soft creeping_crack '[100]')
wide=$(value soft_space_1.0e-3 soft creeping_crack '[100]')
near "bilinear in space: spacing 1.0e-3 m: creeping crack over that of 0.5e-3 m" 1 "$wide" "$finest" \
  "the finer horizon" 0.05
near "bilinear in space: spacing 1.0e-3 m: creeping crack" G0 "$wide" 1.054 \
  "cases/verification/softening, horizon 0.6 E G0/sigma_t2" 0.03
shown "bilinear in space: spacing 0.5e-3 m: creeping crack" G0 "$finest" 1.013 "bonds across a plane of the lattice"
finish
