#!/usr/bin/env bash
# Whether an elastic wall in a channel (Re = 20, two particles thick) stays stable without damping, over its density and
# stiffness, with the load by reaction and with the probe's. Soft walls also over 4000 steps: a wave that grows by 1 % a
# step is not seen in 200.
# usage: cases/stability/stiffness/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../../verification/common.sh" "$@"
# shellcheck source=cases/stability/edge.sh
. "$here/../edge.sh"
# A run of 200 steps is bounded if the wall, late in the run, is less than twice as fast as in the first half, and never
# twice as fast as the stream.
judge() {
  local density
  density=$(sed -n '/^solid/,$s/.*density: *\([0-9.e+-]*\).*/\1/p' "$1/scene.resolved.yaml" | head -n 1)
  [ "$(of_run "$1" e_kinetic_solid \
    "print max(n - 10, n) <= 4 * max(n - 39, n - 20) && max(1, n) <= 2 * $density * 96")" = 1 ]
}
of_scheme() { # of_scheme reaction|reaction_ab2|probe: its settings
  case $1 in
    reaction_ab2) echo coupling.load=reaction stages.bend.fluid_integrator=ab2 ;;
    *) echo "coupling.load=$1" ;;
  esac
}
# of_long SCHEME E/(rho_f U2) RATIO: the wall comes to rest, all but for a thousandth of the largest kinetic energy that
# it had
of_long() {
  local at=$runs/at/long-$1-$2-$3 held=0
  # shellcheck disable=SC2046 # settings are words
  made "$at" scene $(of_scheme "$1") solid.materials.0.youngs_modulus="$2" solid.materials.0.density="$3" \
    stages.bend.steps=4000 && held=$(of_run "$at" e_kinetic_solid "print max(n - int(n / 5), n) <= 1e-3 * max(1, n)")
  echo "$1,$2,$3,$held"
}
point() { # point SCHEME E/(rho_f U2) RATIO: the step has at most about 500 substeps of a wall as dense as the fluid
  local step held=1
  [[ $1 != long-* ]] || { of_long "${1#long-}" "$2" "$3"; return; }
  step=$(calc "($2 > 1.0e7 ? 3.7e-3 * sqrt(1.0e10 / $2) : 0.1)")
  # shellcheck disable=SC2046 # settings are words
  holds "$runs/at/$1-$2-$3" scene $(of_scheme "$1") solid.materials.0.youngs_modulus="$2" \
    solid.materials.0.density="$3" \
    stages.bend.time_step="$step" || held=0
  echo "$1,$2,$3,$step,$held"
}
for e in 1e3 1e4 1e6 1e8 1e10; do
  for scheme in reaction reaction_ab2 probe; do
    printf "$scheme $e %s\n" 100 10 3 1 0.5 0.1 0.01
  done
done >"$runs/points"
table grid 'scheme,stiffness,density_ratio,step,holds' <"$runs/points"
count() { # count SCHEME LEAST: how many walls of at least this density hold
  awk -F, -v s="$1" -v least="$2" '$1 == s && $3 >= least { n += $5 } END { print n + 0 }' "$out/grid.csv"
}
shown "probe: walls of rho_s/rho_f from 0.01 to 100 that hold" 1 "$(count probe 0)" 35 "all"
for scheme in reaction reaction_ab2; do
  for e in 3e2 1e3 3e3 1e4 3e4 1e5 1e6; do printf "long-$scheme $e %s\n" 10 3 1 0.5 0.3 0.1 0.03 0.01; done
done >"$runs/long"
table long 'scheme,stiffness,density_ratio,holds' <"$runs/long"
for scheme in reaction reaction_ab2; do
  what=$([ $scheme = reaction ] && echo "reaction" || echo "reaction, fluid by AB2")
  for least in 0.5 0.01; do
    all=$([ $least = 0.5 ] && echo 25 || echo 35)
    row "$what: walls of rho_s/rho_f from $least to 100 that hold" 1 "$(count $scheme $least)" \
      "$all" "all" "$all" "$all"
  done
  row "$what: soft walls of rho_s/rho_f from 0.01 to 10 that come to rest in 4000 steps" 1 \
    "$(awk -F, -v s=$scheme '$1 == s { n += $4 } END { print n + 0 }' "$out/long.csv")" 56 "all" 56 56
done
plot grid
finish
