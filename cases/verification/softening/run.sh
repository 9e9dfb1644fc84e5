#!/usr/bin/env bash
# Strength and toughness of the bilinear bond law on several horizons: a smooth bar, a creeping crack in a plate and in
# space.
# usage: cases/verification/softening/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
levels="1 1/2 1/4"
finest=1/4
if [ "$quick" ]; then levels="1 1/2" finest=1/2 word=_quick; else word=; fi
study study_bar$word
study study_strip$word
for level in $levels; do
  strength=$(cell study_bar$word value bilinear "$level" strength)
  near "bar, horizon times $level: largest stress over the given strength" 1 "$strength" 1 "the given strength" 0.05
  [ "$level" = "$finest" ] ||
    near "bar, horizon times $level: that stress over the one at the finest horizon" 1 "$strength" \
      "$(cell study_bar$word value bilinear $finest strength)" "the finest horizon" 0.03
  shown "brittle bar, horizon times $level: largest stress over the softening one's strength" 1 \
    "$(cell study_bar$word value brittle "$level" strength)" "" "s0 goes with the horizon's root"
done
for level in $levels; do
  [ "$level" != "$finest" ] && judge=(near 0.03) || judge=(shown)
  "${judge[0]}" "notched bar, horizon times $level: largest stress over the strength" 1 \
    "$(cell study_bar$word value notched "$level" strength)" "$(cell study_bar$word value notched $finest strength)" \
    "the finest horizon" "${judge[@]:1}"
done
for level in $levels; do
  energy=$(cell study_strip$word value bilinear "$level" energy)
  near "crack in a plate, horizon times $level: energy over area" G0 "$energy" 1.02801 \
    "bonds across a plane of the lattice" 0.05
  [ "$level" = "$finest" ] ||
    near "crack in a plate, horizon times $level: that energy over the one at the finest horizon" 1 "$energy" \
      "$(cell study_strip$word value bilinear $finest energy)" "the finest horizon" 0.05
done
if [ ! "$quick" ]; then
  study study_slab
  near "crack in space: energy over area" G0 "$(cell study_slab value bilinear 1 energy)" 1.01313 \
    "bonds across a plane of the lattice" 0.05
fi
finish
