#!/usr/bin/env bash
# Largest speed of a settling sphere, compared with the measured one.
# usage: cases/verification/ten_cate/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
what="largest speed over u_inf" source="ten Cate et al. 2002"
measured() { case $1 in E1) echo 0.947 ;; E2) echo 0.953 ;; E3) echo 0.959 ;; E4) echo 0.955 ;; esac; }
if [ "$quick" ]; then
  study study_quick
  near "E4, 12 cells: $what" 1 "$(cell study_quick value balanced 12 "$what")" 0.955 "$source" 0.05
else
  study study
  study study_fine
  study study_knobs
  for e in E1 E2 E3 E4; do shown "$e, 6 cells: $what" 1 "$(cell study value $e 6 "$what")" "$(measured $e)" \
    "$source"; done
  near "E4, 12 cells: $what" 1 "$(cell study_fine value balanced 12 "$what")" 0.955 "$source" 0.05
  shown "E4, 6 cells, by the probe alone: $what" 1 "$(cell study_fine value probe 6 "$what")" 0.955 "$source"
  near "E4, 12 cells, by the probe alone: $what" 1 "$(cell study_fine value probe 12 "$what")" 0.955 "$source" 0.05
  coarse=$(cell study_fine value probe 6 "$what") fine=$(cell study_fine value probe 12 "$what")
  shown "E4, by the probe alone, of 6 and 12 cells extrapolated with order 1: $what" 1 "$(calc "2 * $fine - $coarse")" \
    0.955 "$source"
  at=$(cell study_knobs value "as it is" 6 "$what")
  near "E4, 6 cells, ten times as stiff: $what" 1 "$(cell study_knobs value "ten times as stiff" 6 "$what")" "$at" \
    "the softer sphere" 5e-3
  near "E4, 6 cells, half the step: $what" 1 "$(cell study_knobs value "half the step" 6 "$what")" "$at" \
    "the longer step" 3e-2
  shown "E4, 6 cells, at its shape: $what" 1 "$(cell study_knobs value "at its shape" 6 "$what")" 0.955 "$source"
fi
finish
