#!/usr/bin/env bash
# Stiff and nearly singular scenes: a crack full of fluid whose load is reversed, pores without an outlet, a crack that
# snaps through, soft posts in a fast stream, ten thousand particles that come apart in a stream, and that fall to a
# floor. All on the defaults of step, integrator and safety; all balances must close.
# shellcheck source=tests/program/extreme/extreme.sh
. "$(dirname "$0")/extreme.sh" "$@"
# closed MOST [momentum]: the log says that the balance of the last stage has closed to less than this
closed() {
  less "balance" "$(sed -n "s/.*${2:-energy balance} has closed to \([^ ]*\) of.*/\1/p" run/run.log | tail -1)" "$1"
}
# at T COLUMN: of the first row from this time on
at() {
  awk -F, -v t="$1" -v name="$2" 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == name) k = i }
    NR > 2 && $2 >= t { print $k; exit }' run/series.csv
}

# linear elasticity: the volume is linear in pressure and load. Beside the faces' opening it has the strain of the body
# between them, over two or three spacings.
go 1 0 "$here/flooded.yaml"
closed 1e-4
rest=$(at 1.99e-4 crack_volume) up=$(at 3.99e-4 crack_volume) down=$(at 6.99e-4 crack_volume)
near "V(+) - V(0) over V(0) - V(-)" 1 0.03 "$(calc "($up - $rest) / ($rest - $down)")"
near "V(+) - V(0) over V(0)/2" 1.03 0.04 "$(calc "2 * ($up - $rest) / $rest")"
near "V at the end" 1 2e-3 "$(calc "$(last crack_volume) / $rest")"
near "volume residual" 0 1e-18 "$(last volume_residual)"
row "a crack full of fluid at 2 MPa, under a tension of 1 MPa that is reversed" \
  "its volume changes by as much either way to 3 %, and comes back to 0.2 %; energy closes to 1e-4"

# Terzaghi's column before it drains, M = infinity: the fluid carries the load. The crack's conductance by its least
# aperture of 10 um is 1e7 times that of the pores.
go 1 0 "$here/undrained.yaml"
closed 1e-4
near "pressure in the crack" 3.0e6 6e3 "$(last crack_pressure_mean)"
near "volume residual" 0 1e-24 "$(last volume_residual)"
row "incompressible pores without an outlet, beside a crack that conducts 1e7 times as well" \
  "the fluid in the crack bears the load to 0.2 %; energy closes to 1e-4"

# K_I = K_IC at one displacement, whatever the increment; then the strip's energy breaks it at once
for n in 10 20 40 80; do
  go 1 0 "$here/snap.yaml" --set stages.pull.steps=$n --set stages.pull.increment="$(calc "1 / $n")"
  work=$(last e_constraint)
  near "balance" 0 1e-3 "$(calc "($(last e_strain) + $(last e_fracture) + $(last e_damped)) / $work - 1")"
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) a[$i] = i }
    NR == 3 { b = $a["bonds_broken"] } NR > 3 && $a["bonds_broken"] > b { print $2; exit }' run/series.csv >>begins
  last bonds_broken >>broken
done
near "begin, 20 increments" 0.15 1e-9 "$(sed -n 2p begins)"
near "begin, 40 increments" 0.15 0.026 "$(sed -n 3p begins)"
near "begin, 80 increments" 0.15 0.013 "$(sed -n 4p begins)"
for k in 1 2 3; do near "broken bonds" 1 0.05 "$(calc "$(sed -n ${k}p broken) / $(sed -n 4p broken)")"; done
row "a crack that snaps through a long strip, with 10, 20, 40 and 80 increments" \
  "begins at the same displacement within an increment; the same bonds break to 5 %; energy closes to 0.1 %"

go 2 0 "$here/posts.yaml"
closed 0.01
closed 1e-9 momentum
less "momentum residual" "$(last momentum_residual)" 1e-9
row "soft posts in a stream with a cell Reynolds number of 100" \
  "energy closes to 1 %, momentum to 1e-9"

go 2 0 "$here/heap.yaml"
closed 1e-4
closed 1e-9 momentum
less "largest share of whole bonds" "$(calc "$(last bonds_intact) / 790580")" 0.05
less "-fragments" "$(calc "-$(last fragments)")" -5000
row "10,648 particles that come apart in a stream, and stay in contact" \
  "energy closes to 1e-4, momentum to 1e-9"

go 1 0 "$here/pile.yaml"
closed 1e-4
closed 1e-9 momentum
row "10,648 loose particles that fall to the floor of a channel" \
  "energy closes to 1e-4, momentum to 1e-9"
echo ok
