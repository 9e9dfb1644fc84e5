#!/usr/bin/env bash
# A solid alone: without breakage, with breakage of all bonds, and with very large and very small numbers.
# shellcheck source=tests/program/extreme/extreme.sh
. "$(dirname "$0")/extreme.sh" "$@"
# velocity Verlet's energy oscillates by up to (w dt)^2/4 of its value, which is safety^2
swing=2.5e-3 # safety 0.05
energy() { calc "$(of "$1" e_kinetic_solid) + $(of "$1" e_strain)"; }
# stretched in all directions: every bond is longer than at the start
pulses=()
for axis in x y z; do
  way=$(for c in x y z; do [ $c = $axis ] && printf '1.0e-3,' || printf '0,'; done | sed 's/,$//')
  pulses+=("{shape: gaussian, along: $axis, centre: 0.2, width: 0.1, displacement: [$way]}")
done
pulled="solid.initial=[${pulses[0]}, ${pulses[1]}, ${pulses[2]}]"
material() { echo "solid.materials.stuff.$1"; }
box='solid.bodies=[{shape: box, low: [0.03, 0.03, 0.03], high: [0.05, 0.04, 0.04]}]'
grain='solid.bodies=[{shape: sphere, centre: [0.055, 0.055, 0.055], radius: 0.006}]'

go 1 0 "$solid" --set "$pulled" --set stages.run.safety=0.05
start=$(energy 1)
near "energy after 100 steps" "$start" "$(calc "$swing * $start")" "$(energy last)"
for g in 1e300 1e-300; do
  go 2 0 "$solid" --set "$pulled" --set stages.run.safety=0.05 --set "$(material fracture_energy)=$g"
  if [ $g = 1e300 ]; then
    near "broken bonds" 0 0 "$(last bonds_broken)"
    near "energy after 100 steps" "$start" "$(calc "$swing * $start")" "$(energy last)"
    row "G₀ = 1e300 J/m²" "nothing breaks; energy kept to 0.25 %"
  else
    near "intact bonds after a step" 0 0 "$(of 1 bonds_intact)"
    near "energy released" "$start" "$(calc "$swing * $start")" "$(of 1 e_fracture)"
    near "fragments" 125 0 "$(last fragments)"
    near "kinetic energy" 0 0 "$(last e_kinetic_solid)"
    row "G₀ = 1e-300 J/m², all bonds stretched" \
      "all break in the first step and release what they held; 125 fragments stay where they are"
  fi
done

for m in 1 4.49; do
  go 1 0 "$solid" --set "$pulled" --set "$(material horizon_ratio)=$m" --set stages.run.safety=0.05
  near "energy at m = $m" "$(energy 1)" "$(calc "$swing * $(energy 1)")" "$(energy last)"
done
row "horizon of 1 and of 4.49 spacings" "runs; energy kept to 0.25 %"

for e in 1 1e12; do
  go 1 0 "$solid" --set "$pulled" --set "$(material youngs_modulus)=$e"
  echo "$(calc "$(last e_strain) / $e") $(calc "$(last t) * sqrt($e)")" >scaled_$e
done
read -r strain time <scaled_1
read -r other_strain other_time <scaled_1e12
near "e_strain / E" "$strain" "$(calc "1e-9 * $strain")" "$other_strain"
near "t sqrt(E)" "$time" "$(calc "1e-12 * $time")" "$other_time"
row "E = 1 Pa and E = 1e12 Pa" "the same motion in times a million apart"
go 1 2 "$solid" --set "$(material youngs_modulus)=1e300"
row "E = 1e300 Pa" "is refused"
go 1 2 "$solid" --set "$(material poisson_ratio)=0.46"
row "Poisson's ratio 0.46" "is refused"

# a free body and a very soft one in permanent fall
go 2 0 "$solid" --set 'solid.body_force=[0, -1.0e5, 0]' --set "$(material fracture_energy)=1" --set stages.run.steps=400
fallen=$(calc "0.5 * 0.125 * (1e5 * $(last t)) ^ 2")
near "kinetic energy" "$fallen" "$(calc "1e-12 * $fallen")" "$(last e_kinetic_solid)"
less "strain energy" "$(last e_strain)" "$(calc "1e-15 * $fallen")"
near "broken bonds" 0 0 "$(last bonds_broken)"
row "a free body leaves the domain for good, by 1800 m" "½ m g² t² to round-off; it is not strained"
go 1 0 "$solid" --set 'solid.body_force=[0, -10, 0]' --set "$(material youngs_modulus)=1" --set stages.run.steps=400
fallen=$(calc "0.5 * 0.125 * (10 * $(last t)) ^ 2")
near "kinetic energy" "$fallen" "$(calc "1e-12 * $fallen")" "$(last e_kinetic_solid)"
row "a body falls at 60,000 times its wave speed" "falls on: a speed that a force explains ends no run"

go 1 0 "$solid" --set "$grain" --set 'solid.body_force=[0, -10, 0]' --set stages.run.time_step=1e-3 \
  --set 'output.probes={every: 100, at: [[0.055, 0.055, 0.055]]}'
near "fall of a particle" -0.05 1e-15 "$(probe 0 100 displacement_y)"
row "one particle, free" "falls by g t²/2 to round-off"
go 1 2 "$solid" --set "$grain"
row "one particle, free, automatic step" "is refused"
held=(--set 'solid.constraints=[{low: [0, 0, 0], high: [0.2, 0.1, 0.1]}]'
  --set 'solid.loads=[{low: [0, 0, 0], high: [0.2, 0.1, 0.1], force: [1.0e9, 0, 0]}]')
go "$few" 0 "$solid" "${held[@]}" --set stages.run.time_step=1e-4
near "kinetic energy" 0 0 "$(last e_kinetic_solid)"
near "strain energy" 0 0 "$(last e_strain)"
row "all particles held, under a load" "nothing moves"

shift_=(--set "$box"
  --set 'solid.initial=[{shape: gaussian, along: x, centre: 0, width: 0.1, displacement: [1.0e-4, 0, 0]}]')
go 1 0 "$solid" "${shift_[@]}" && mv run alone
go 4 0 "$solid" "${shift_[@]}"
same alone/series.csv run/series.csv
row "two particles on four ranks" "as on one"

go 1 0 "$solid" --set 'stages=[{name: none, steps: 0}, {name: one, steps: 1}, {name: last, steps: 0}]'
near "steps" 1 0 "$(last step)"
row "stages of no steps and of one" "one row"
go 1 2 "$solid" --set "$pulled" --set stages.run.time_step=1e-300
row "a time step of 1e-300 s" "is refused"
go 1 2 "$solid" --set stages.run.time_step=1e300
row "a time step of 1e300 s" "is refused"
go 1 3 "$solid" --set "$grain" --set 'solid.body_force=[0, -10, 0]' --set stages.run.time_step=1e300
[ -f run/checkpoint/latest ] || fail "no checkpoint"
row "the same of one free particle" "the state before it is kept"
go 1 0 "$solid" --set "$grain" --set stages.run.time_step=1e-5 --set stages.run.steps=10000
near "rows" 10002 0 "$(wc -l <run/series.csv)"
row "a row a step for 10,000 steps" "10,000 rows"

mkdir -p 'kühl und grau'
echo '0.05 0.05 0.05 1.0e-6' >'kühl und grau/Körner.txt'
code 0 ranks 1 run "$solid" --out 'kühl und grau/läuft' \
  --set "solid.bodies=[{name: Körner, shape: points, file: '$PWD/kühl und grau/Körner.txt'}]" \
  --set stages.run.time_step=1e-5 --set output.fields_every=100
[ -s 'kühl und grau/läuft/fields/solid_00000100.hdf' ] || fail "no field"
ended=0
row "paths with blanks and umlauts" "files where they should be"

# a bar of 1 x 1 x 1000 particles: d'Alembert's two pulses, each half potential, half kinetic
go "$few" 0 "$solid" --set 'domain.size=[10, 0.01, 0.01]' \
  --set 'solid.bodies=[{shape: box, low: [0, 0, 0], high: [10, 0.01, 0.01]}]' \
  --set 'solid.initial=[{shape: gaussian, along: x, centre: 5, width: 0.2, displacement: [1.0e-4, 0, 0]}]' \
  --set stages.run.safety=0.5 --set stages.run.steps=200
near "kinetic share" 0.5 0.01 "$(calc "$(last e_kinetic_solid) / $(energy last)")"
row "a domain and body of 1000 : 1 : 1" "a pulse parts in two that share its energy"
echo ok
