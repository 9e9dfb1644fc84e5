#!/usr/bin/env bash
# Very small plates, cracks outside of the material, and refinement everywhere at once.
# shellcheck source=tests/program/extreme/extreme.sh
. "$(dirname "$0")/extreme.sh" "$@"
energy() { calc "$(of "$1" e_kinetic_solid) + $(of "$1" e_strain)"; }
body() { echo "solid.bodies=[{name: plate, shape: rectangle, low: [$1], high: [$2]}]"; }
hole() { echo "solid.bodies.plate.holes=[{shape: rectangle, low: [$1], high: [$2]}]"; }
crack() { echo "solid.cracks=[{points: [[$1], [$2]]}]"; }

go 1 0 "$plate" --set "$(body '0.005, 0.005' '0.006, 0.006')" --set stages.run.time_step=1e-7 \
  --set 'solid.body_force=[0, -10]' --set 'output.probes={every: 200, at: [[0.0055, 0.0055]]}' \
  --set output.checkpoint_every=100
near "fall" -2e-9 1e-21 "$(calc "$(probe 0 200 displacement_y) - ($(probe 0 0 displacement_y))")"
[ -f run/checkpoint/stage_run.h5 ] || fail "no checkpoint"
row "a plate of one particle" "falls by g t²/2 to round-off, with checkpoints"
go 1 0 "$plate" --set "$(body '0.005, 0.005' '0.025, 0.006')"
near "bonds, three to each side of 20 particles" 54 0 "$(last bonds_intact)"
row "a plate of one row" "runs"
go 4 0 "$plate" --set "$(body '0.005, 0.005' '0.007, 0.006')"
near "bonds" 1 0 "$(last bonds_intact)"
row "a plate of two particles on four ranks" "runs"

go 1 2 "$plate" --set "$(crack '0.005, 0.015' '0.025, 0.015')"
row "a crack along the plate's edge" "is refused"
go 1 0 "$plate" --set "$(crack '0.005, 0.010' '0.025, 0.010')"
near "fragments" 2 0 "$(last fragments)"
near "the larger" 100 0 "$(last largest_fragment)"
row "a crack from edge to edge" "two halves"
go 1 2 "$plate" --set "$(hole '0.005, 0.005' '0.025, 0.015')"
row "a hole as large as the plate" "is refused"
go 1 2 "$plate" --set "$(hole '0, 0' '0.03, 0.02')"
row "a hole larger than the plate" "is refused"

go 2 0 "$plate" --set solid.materials.glass.fracture_energy=1e-300
near "fragments: what is not stretched, rows, holds" 10 0 "$(last fragments)"
near "the largest" 20 0 "$(last largest_fragment)"
near "kinetic energy" 0 0 "$(last e_kinetic_solid)"
row "G₀ = 1e-300 J/m², bonds between rows stretched" "ten rows, at rest"
go "$few" 0 "$plate" \
  --set 'solid.refinement={levels: 3, energy: off, start: [{low: [0, 0], high: [0.03, 0.02], level: 3}]}' \
  --set stages.run.safety=0.05
near "particles: 8 a spacing and one more" "$((161 * 81))" 0 "$(last particles)"
near "energy" "$(energy 1)" "$(calc "2.5e-3 * $(energy 1)")" "$(energy last)"
row "everything refined from the start, three levels" "13,041 particles for 200; energy kept to 0.25 %"
go "$few" 0 "$plate" --set 'solid.refinement={levels: 3, energy: 1.0e-9, every: 1}' --set stages.run.steps=20
near "particles" "$((161 * 81))" 0 "$(last particles)"
row "everything refined at once while it runs" "the same 13,041 particles"
go 1 2 "$plate" --set solid.thickness=1e-300
row "a plate 1e-300 m thick" "is refused"
echo ok
