#!/usr/bin/env bash
# Frequencies of the lattice's waves, orders of the integrators in time, and the longest stable steps by bisection.
# usage: cases/verification/standing_waves/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
study study
for wave in longitudinal transverse; do
  for length in 40 20 10 4 2; do
    near "$wave wave of $length spacings: frequency over the lattice's" 1 \
      "$(cell study value $wave $length frequency)" 1 "sum over the bonds of the lattice" 1e-6
  done
done
study study_time
for level in 1/4 1/8 1/16; do
  row "order of RK3 to a step of $level" 1 "$(cell study_time order RK3 $level displacement)" 3 "RK3" 2.8 3.2
  row "order of Verlet to a step of $level" 1 "$(cell study_time order Verlet $level displacement)" 2 "Verlet" 1.9 2.1
done
# grows INTEGRATOR STEP: whether the energy exceeds a thousand times that at the start, or is not a number
grows() {
  rm -rf "$runs/stability"
  "$frana" run "$here/stability.yaml" --out "$runs/stability" --set stages.swing.integrator="$1" \
    --set stages.swing.time_step="$2" >"$runs/stability.log" 2>&1 ||
    { [ $? = 3 ] && return 0; cat "$runs/stability.log" >&2; exit 1; }
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    NR > 2 { e = $at["e_kinetic_solid"] + $at["e_strain"]; if (!start) start = e }
    END { exit !(e > 1000 * start || e != e) }' "$runs/stability/series.csv"
}
# longest INTEGRATOR EXPECTED: the longest stable step between 0.9 and 1.1 of EXPECTED, to a thousandth
longest() {
  local low high middle
  low=$(calc "0.9 * $2") high=$(calc "1.1 * $2")
  ! grows "$1" "$low" || { echo 0; return; }
  for _ in 1 2 3 4 5 6 7 8; do
    middle=$(calc "($low + $high) / 2")
    if grows "$1" "$middle"; then high=$middle; else low=$middle; fi
  done
  echo "$low"
}
omega=1.1039 # the lattice's largest
near "longest stable step of RK3" "spacing/sqrt(E/density)" "$(kept "longest of RK3" longest rk3 1.569)" 1.569 \
  "sqrt(3)/$omega" 0.02
near "longest stable step of Verlet" "spacing/sqrt(E/density)" \
  "$(kept "longest of Verlet" longest verlet 1.812)" 1.812 "2/$omega" 0.02
limit() { "$frana" check "$here/stability.yaml" | awk '/solid, bonds, RK3/ { print $NF }'; }
near "RK3's stable step as frana finds it" "spacing/sqrt(E/density)" "$(kept "limit of RK3" limit)" 1.569 \
  "sqrt(3)/$omega" 0.02
finish
