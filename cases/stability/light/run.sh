#!/usr/bin/env bash
# Whether a free body much lighter than the fluid stays calm without damping: a sphere that a weak force drives from
# rest, over its stiffness in steps of 1.3, its density, the step and the fluid's scheme.
# usage: cases/stability/light/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../../verification/common.sh" "$@"
# shellcheck source=cases/stability/edge.sh
. "$here/../edge.sh"
point() { # point SCHEME STEP/ms STEPS RATIO E: the largest strain energy of the last third over that of the middle one
  local dir=$runs/at/$1-$2-$4-$5 growth=inf
  # as one line of series.csv is written every 20 steps, waves of all periods are in it
  made "$dir" scene stages.drift.fluid_integrator="$1" stages.drift.time_step="$2e-3" stages.drift.steps="$3" \
    solid.materials.0.density="$4" solid.materials.0.youngs_modulus="$5" &&
    growth=$(of_run "$dir" e_strain 'printf "%.4g\n", max(int(2 * n / 3), n) / max(int(n / 3), int(2 * n / 3))')
  echo "$1,$2,$4,$5,$growth"
  rm -rf "$dir" "$dir.log"
}
# lines FACTOR SCHEME STEP STEPS RATIO...: E from 20 to 2e5 by the factor
lines() {
  local factor=$1 ratio
  shift
  for ratio in "${@:4}"; do
    awk -v factor="$factor" -v line="$1 $2 $3 $ratio" \
      'BEGIN { for (e = 20; e < 2.1e5; e *= factor) printf "%s %.4g\n", line, e }'
  done
}
{ lines 1.3 rk3 4 1500 0.02 0.1 0.5; lines 2.2 ab2 4 900 0.02 0.1; lines 2.2 rk3 1 900 0.02 0.1
  lines 2.2 rk3 12 600 0.02 0.1; } >"$runs/points"
table light 'scheme,step_ms,density_ratio,stiffness,growth' <"$runs/points"
for what in rk3,4 ab2,4 rk3,1 rk3,12; do
  most() { # most: the largest growth, a million if a run is unstable
    awk -F, -v what="$what" '$1 "," $2 == what { g = $5 == "inf" ? 1e6 : $5 + 0; if (g > most) most = g; n++ }
      END { print n == 0 ? "none" : most }' "$out/light.csv"
  }
  row "${what%,*}, steps of ${what#*,} ms: largest growth of the strain energy of any body" 1 "$(most)" 1 \
    "a steady drift (1e6: the run ends as unstable)" 0 1.5
done
plot light
finish
