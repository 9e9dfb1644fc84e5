#!/usr/bin/env bash
# Largest speed of a settling sphere, compared with the measured one.
# usage: cases/verification/ten_cate/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
what="largest speed over u_inf" source="ten Cate et al. 2002"
measured() { case $1 in E1) echo 0.947 ;; E2) echo 0.953 ;; E3) echo 0.959 ;; E4) echo 0.955 ;; esac; }
if [ "$quick" ]; then
  study study_quick
  near "E4, 12 cells: $what" 1 "$(cell study_quick value E4 12 "$what")" 0.955 "$source" 0.05
else
  study study
  study study_fine
  study study_loads
  study study_knobs
  for e in E1 E2 E3 E4; do
    near "$e, 12 cells: $what" 1 "$(cell study_fine value $e 12 "$what")" "$(measured $e)" "$source" 0.05
    shown "$e, 6 cells: $what" 1 "$(cell study value $e 6 "$what")" "$(measured $e)" "$source"
  done
  for load in reaction probe wall balanced; do
    near "E4, 12 cells, load $load: $what" 1 "$(cell study_loads value $load 12 "$what")" 0.955 "$source" 0.05
    shown "E4, 6 cells, load $load: $what" 1 "$(cell study_loads value $load 6 "$what")" 0.955 "$source"
  done
  at=$(cell study_knobs value "as it is" 6 "$what")
  near "E4, 6 cells, ten times as stiff: $what" 1 "$(cell study_knobs value "ten times as stiff" 6 "$what")" "$at" \
    "the softer sphere" 5e-3
  near "E4, 6 cells, half the step: $what" 1 "$(cell study_knobs value "half the step" 6 "$what")" "$at" \
    "the longer step" 3e-2
  near "E4, 6 cells, damped: $what" 1 "$(cell study_knobs value damped 6 "$what")" "$at" "without damping" 5e-3
  shown "E4, 6 cells, at its shape: $what" 1 "$(cell study_knobs value "at its shape" 6 "$what")" 0.955 "$source"
fi
finish
