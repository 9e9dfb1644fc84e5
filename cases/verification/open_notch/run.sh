#!/usr/bin/env bash
# A notch below the grid that is open to a resolved fluid: it fills to the fluid's pressure and opens as the solid alone
# does; under a pressure that is the same all around it does not open; the books of volume.
# usage: cases/verification/open_notch/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
run_of open scene.yaml
run_of alone alone.yaml
run_of even scene.yaml fluid.sides.x_high.pressure=100 'solid.bodies.wall.low=[0.012, 0.008, 0]' \
  'solid.bodies.wall.high=[0.028, 0.024, 0.008]' solid.constraints=[]
run_of probe scene.yaml coupling.load=probe
# last NAME COLUMN: of a run's series
last() {
  awk -F, -v c="$2" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } END { printf "%.12g\n", $at[c] }' \
    "$runs/$1/series.csv"
}
value() { kept "$1 $2" last "$@"; }
near "pressure in the mouths" Pa "$(value open mouth_pressure)" 100 "the side's pressure" 0.01
near "mean pressure in the notch" Pa "$(value open crack_pressure_mean)" 100 "the side's pressure" 0.01
near "load on the wall" N "$(value open load_x)" 0.0256 "pressure times area" 0.01
near "volume of the notch" m3 "$(value open crack_volume)" "$(value alone crack_volume)" "the solid alone" 0.05
near "largest aperture" m "$(value open aperture_max)" "$(value alone aperture_max)" "the solid alone" 0.05
near "volume of the notch, load probe" m3 "$(value probe crack_volume)" "$(value alone crack_volume)" \
  "the solid alone" 0.05
near "volume that entered" m3 "$(value open mouth_volume)" "$(value open crack_volume)" "volume of the notch" 1e-10
near "volume that the fluid gave" m3 "$(value open handed_volume)" "$(value open crack_volume)" "volume of the notch" \
  1e-4
at_most "balance of volume over the volume" 1 \
  "$(calc "$(value open volume_residual) / $(value open crack_volume)")" 0 "definition" 1e-12
at_most "same pressure all around: volume over that of the open notch" 1 \
  "$(calc "$(value even crack_volume) / $(value open crack_volume)")" 0 "nothing opens" 0.1
finish
