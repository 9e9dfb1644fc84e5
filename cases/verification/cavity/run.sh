#!/usr/bin/env bash
# Extrema of the velocities on the centrelines, compared with spectral and extrapolated solutions.
# usage: cases/verification/cavity/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
marchi() { case $1 in u_min) echo -0.2140417 ;; v_max) echo 0.1795728 ;; v_min) echo -0.2538030 ;; esac; }
botella() { case $1 in u_min) echo -0.3885698 ;; v_max) echo 0.3769447 ;; v_min) echo -0.5270771 ;; esac; }
study study
for what in u_min v_max v_min; do
  near "Re 100 at 64^2: $what" m/s "$(cell study value RK3 64 $what)" "$(marchi $what)" "Marchi et al. 2009" 7e-3
  row "Re 100: order of $what to 64^2" 1 "$(cell study order RK3 64 $what)" 2 "second order" 1.7 2.3
done
if [ ! "$quick" ]; then
  study study_fine
  study study_1000
  for what in u_min v_max v_min; do
    near "Re 100 at 128^2: $what" m/s "$(cell study_fine value RK3 128 $what)" "$(marchi $what)" "Marchi et al. 2009" \
      2e-3
    row "Re 100: order of $what to 128^2" 1 "$(cell study_fine order RK3 128 $what)" 2 "second order" 1.7 2.3
    coarse=$(cell study_1000 value RK3 64 $what) fine=$(cell study_1000 value RK3 128 $what)
    near "Re 1000 at 128^2: $what" m/s "$fine" "$(botella $what)" "Botella and Peyret 1998" 1.5e-2
    row "Re 1000: order of $what to 128^2" 1 "$(cell study_1000 order RK3 128 $what)" 2 "second order" 1.7 2.3
    shown "Re 1000: $what, extrapolated with order 2 from 64^2 and 128^2" m/s \
      "$(calc "$fine + ($fine - ($coarse)) / 3")" "$(botella $what)" "Botella and Peyret 1998"
  done
fi
finish
