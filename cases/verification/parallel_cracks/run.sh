#!/usr/bin/env bash
# Two parallel cracks under one pressure, at rest, by their distance and length; two of different length that one well
# feeds.
# usage: cases/verification/parallel_cracks/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# number_of RUN SCRIPT NUMBER: kept
in_run() { (cd "$runs/$1" && "$here/$2.sh" "$3"); }
number_of() { kept "$1 $3" in_run "$@"; }
# at_rest NAME DISTANCE FIRST SECOND [SETTING...]: cracks with half lengths FIRST and SECOND, all in mm
at_rest() {
  local low high
  low=$(calc "0.12 - $2 / 2000") high=$(calc "0.12 + $2 / 2000")
  run_of "$1" scene.yaml "solid.cracks[0].points=$(crack "$3" "$low")" \
    "solid.cracks[1].points=$(crack "$4" "$high")" \
    "crack_fluid.injections[0].low=[0.1, $(calc "$low - 0.01")]" \
    "crack_fluid.injections[0].high=[0.14, $(calc "$high + 0.01")]" \
    "output.probes={at: [$(probed "$low"), $(probed "$high")], every: 10}" "${@:5}"
}
crack() { echo "[[$(calc "0.12 - $1 / 1000"), $2], [$(calc "0.12 + $1 / 1000"), $2]]"; } # half length, height
half=0.0005 # of a spacing
probed() { echo "[0.1205, $(calc "$1 + $half")], [0.1205, $(calc "$1 - $half")]"; } # above and below a crack's middle
# judged NAME WHAT VOLUME FIRST SECOND TOLERANCE: the references are interaction.py's
judged() {
  near "$2: volume over Sneddon's" 1 "$(number_of "$1" parallel volume)" "$3" "interaction.py" "$6"
  near "$2: opening of the first over Sneddon's" 1 "$(number_of "$1" parallel first)" "$4" "interaction.py" "$6"
  [ ! "$5" ] ||
    near "$2: opening of the second over Sneddon's" 1 "$(number_of "$1" parallel second)" "$5" "interaction.py" "$6"
}
if [ "$quick" ]; then # twice the tolerance at a spacing of 2 mm
  half=0.001
  at_rest coarse 24 12 12 solid.spacing=2.0e-3 stages.pump.steps=280
  judged coarse "two of 12 mm, 24 mm apart, 2 mm" 0.811053 0.799217 "" 0.1
  finish
  exit
fi
at_rest apart_12 12 12 12
judged apart_12 "a = 4 horizons, a apart" 0.687191 0.658575 "" 0.05
at_rest apart_24 24 12 12
judged apart_24 "a = 4 horizons, 2 a apart" 0.811053 0.799217 "" 0.05
at_rest apart_48 48 12 12
judged apart_48 "a = 4 horizons, 4 a apart" 0.924936 0.923241 "" 0.05
at_rest unequal 16 12 18
judged unequal "a = 4 and 6 horizons, 16 spacings apart" 0.751428 0.458010 0.847977 0.05
for name in apart_12 apart_24 apart_48 unequal; do
  row "$name: bonds that break" 1 "$(number_of $name parallel broken)" 0 "at rest" 0 0
done

run_of well well.yaml
at_most "one well: volume residual over the injected volume" 1 "$(number_of well well books)" 0 exact 1e-12
row "one well: growth of a wing of the longer crack" spacings "$(number_of well well longer)" 10 "asked for" 10
at_most "one well: growth of a wing of the shorter crack" spacings "$(number_of well well shorter)" 0 \
  "interaction.py, a third of the longer crack's energy release rate" 1
at_most "one well: pressure while the longer crack grows: mean deviation" 1 "$(number_of well well pressure)" 0 \
  "interaction.py, K_I = K_IC with 1.4377 G0" 0.2
shown "one well: pressure while the longer crack grows: mean of the ratio" 1 "$(number_of well well pressure_ratio)" 1 \
  "interaction.py, K_I = K_IC with 1.4377 G0"
shown "one well: largest pressure over that of K_I = K_IC at the longer crack" 1 "$(number_of well well first)" 1 \
  "interaction.py"
[ "$again" ] || awk 'NR <= 2 || NR % 6 == 0' "$runs/well/growth.csv" >"$out/growth.csv"
finish
