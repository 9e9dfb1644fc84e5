#!/usr/bin/env bash
# A borehole with two notches that is pumped up until it breaks down, by the length of the notches, and under stresses
# at infinity; a hole without notches.
# usage: cases/verification/borehole/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# number_of RUN NUMBER: a number of borehole.sh of a run; kept
in_run() { (cd "$runs/$1" && "$here/borehole.sh" "$2"); }
number_of() { kept "$1 $2" in_run "$@"; }
# pumped NAME NOTCH [SETTING...]: the scene with notches of NOTCH m
pumped() {
  run_once "$1" scene.yaml "solid.cracks[0].points=[[0.192, 0.18], [$(calc "0.192 + $2"), 0.18]]" \
    "solid.cracks[1].points=[[0.168, 0.18], [$(calc "0.168 - $2"), 0.18]]" "${@:3}"
}
# pressed ALONG [ACROSS]: compressions of the sides in Pa, along the notches and across them
pressed() {
  local rise='time: [[0, 0], [3.0e-4, 1]]'
  echo "solid.loads=[{edge: {from: [0, 0], to: [0, 0.36]}, traction: [$1, 0], $rise}," \
    "{edge: {from: [0.36, 0], to: [0.36, 0.36]}, traction: [-$1, 0], $rise}$([ ! "${2-}" ] ||
      echo ", {edge: {from: [0, 0], to: [0.36, 0]}, traction: [0, $2], $rise}," \
        "{edge: {from: [0, 0.36], to: [0.36, 0.36]}, traction: [0, -$2], $rise}")]"
}
# The sides are pressed with damping, then fluid is injected without. The fluid is let through where the sides press
# ring and plug together, also in the runs without stress that they are compared with.
later=('stages=[{name: press, steps: 1030, integrator: verlet, crack_fluid: true, damping_absolute: 5.0e4},
    {name: pump, steps: 1450, integrator: verlet, crack_fluid: true}]' crack_fluid.least_aperture=3.0e-5
  'crack_fluid.injections[0].time=[[5.5e-4, 0], [7.5e-4, 1]]')
lefm="linear elasticity, K_I = K_IC with 1.4377 G0"
export creeping=1.4377 along=0 confined=0

if [ "$quick" ]; then # 2 mm, in a smaller plate
  pumped coarse 0.012 solid.spacing=2.0e-3 stages.pump.steps=640 output.crack.every=5 output.series_every=5 \
    'solid.bodies[0].low=[0.06, 0.06]' 'solid.bodies[0].high=[0.3, 0.3]' \
    'crack_fluid.injections[0].low=[0.16, 0.16]' 'crack_fluid.injections[0].high=[0.2, 0.2]'
  near "notches of 1 R, 2 mm: breakdown pressure" Pa "$(number_of coarse breakdown)" \
    "$(calc "$(number_of coarse breakdown) / $(number_of coarse breakdown_ratio)")" "$lefm" 0.3
  at_most "notches of 1 R, 2 mm: volume residual over the injected volume" 1 "$(number_of coarse books)" 0 exact 1e-12
  finish
  exit
fi

# a notch on the ring itself breaks no more bonds than the ring
run_once hole scene.yaml 'solid.cracks[0].points=[[0.192, 0.18], [0.191769423, 0.182341084]]' \
  'solid.cracks[1].points=[[0.168, 0.18], [0.168230577, 0.177658916]]' stages.pump.steps=600
near "hole without notches: volume of the ring over that of linear elasticity, 1.875 p R/E wide" 1 \
  "$(number_of hole volume)" 1 "Lame" 0.05

names=(0.5 1 2) notches=(0.006 0.012 0.024) rates=(2.0e-6 2.0e-6 3.2e-6) # the longer, the more volume
for i in 0 1 2; do
  name=notch_${names[i]}
  pumped "$name" "${notches[i]}" "crack_fluid.injections[0].rate=${rates[i]}"
  near "notches of ${names[i]} R: breakdown pressure" Pa "$(number_of "$name" breakdown)" \
    "$(calc "$(number_of "$name" breakdown) / $(number_of "$name" breakdown_ratio)")" "$lefm" 0.2
done
for i in 0 2; do
  near "notches of ${names[i]} R: breakdown pressure over that of 1 R, and by linear elasticity" 1 \
    "$(calc "$(number_of "notch_${names[i]}" breakdown) / $(number_of notch_1 breakdown)")" \
    "$(calc "$(number_of "notch_${names[i]}" breakdown) / $(number_of "notch_${names[i]}" breakdown_ratio) \
      * $(number_of notch_1 breakdown_ratio) / $(number_of notch_1 breakdown)")" "linear elasticity" 0.05
done
for i in 0 1 2; do
  name=notch_${names[i]}
  at_most "notches of ${names[i]} R: pressure over the growing cracks: mean deviation" 1 \
    "$(number_of "$name" pressure)" 0 "$lefm" 0.2
  at_most "notches of ${names[i]} R: volume residual over the injected volume" 1 "$(number_of "$name" books)" 0 \
    exact 1e-12
  shown "notches of ${names[i]} R: growth" spacings "$(number_of "$name" grown)" "" ""
  shown "notches of ${names[i]} R: pressure over the growing cracks: mean of the ratio" 1 \
    "$(number_of "$name" pressure_ratio)" 1 "$lefm"
  shown "notches of ${names[i]} R: energy release rate at breakdown" G0 "$(number_of "$name" energy_begin)" 1.4377 \
    "creeping crack, frana calibrate"
done
[ "$again" ] || awk 'NR <= 2 || NR % 4 == 0' "$runs/notch_1/record.csv" >"$out/record.csv"

# a compression in both directions: by net pressures, and by tractions on a lattice that is strained by them
pumped net 0.012 crack_fluid.least_pressure=-1.0e7
near "compression of 10 MPa, net pressures: breakdown pressure less 10 MPa" Pa "$(number_of net breakdown)" \
  "$(number_of notch_1 breakdown)" "without it" 0.01
pumped free_1 0.012 crack_fluid.least_aperture=3.0e-5 stages.pump.steps=1200
free=$(number_of free_1 breakdown) growing=$(number_of free_1 pressure_ratio)
for s in 10 5; do
  confined=$s.0e6
  pumped "confined_$s" 0.012 "$(pressed $confined $confined)" "${later[@]}"
  factor=$(calc "1 + 0.625 * $s / 20.8886")
  near "compression of $s MPa by tractions: breakdown pressure less it, over that without" 1 \
    "$(calc "$(number_of "confined_$s" breakdown) / $free")" "$factor" "1 + 0.625 sigma0/(E s0)" 0.05
  shown "compression of $s MPa by tractions: pressure before the injection less it" Pa \
    "$(number_of "confined_$s" rest)" 0 "no volume"
  shown "compression of $s MPa by tractions: mean pressure over the growing cracks, over that without" 1 \
    "$(calc "$(number_of "confined_$s" pressure_ratio) / $growing")" "$factor" "1 + 0.625 sigma0/(E s0)"
  confined=0
done

# a compression along the notches: what is left of two unequal stresses when the smaller one is taken off the pressure
pumped free_0.5 0.006 crack_fluid.least_aperture=3.0e-5 stages.pump.steps=900
free=$(number_of free_0.5 breakdown) ratio=$(number_of free_0.5 breakdown_ratio)
along=-5.0e6
pumped along 0.006 "$(pressed 5.0e6)" "${later[@]}"
pressure=$(number_of along breakdown) reference=$(number_of along breakdown_ratio)
near "notches of 0.5 R, compression of 5 MPa along them: breakdown pressure over that without" 1 \
  "$(calc "$pressure / $free")" "$(calc "$pressure / $reference * $ratio / $free")" "linear elasticity" 0.05
# K at the start is 1 + 0.3125 sigma/(E s0) times that without, and F_p p = K/sqrt(pi a) + F_s sigma
shown "notches of 0.5 R, compression of 5 MPa along them: breakdown pressure over that without" 1 \
  "$(calc "$pressure / $free")" "$(calc "1 + 0.3125 * 5 / 20.8886 - 0.26893 / 1.56386 * 5.0e6 / $free")" \
  "linear elasticity, K_IC times 1 + 0.3125 sigma/(E s0)"
shown "notches of 0.5 R, compression of 5 MPa along them: pressure over the growing cracks: mean of the ratio" 1 \
  "$(number_of along pressure_ratio)" 1 "$lefm"
finish
