#!/usr/bin/env bash
# Waves over refined plates: reflection by a patch; the dual horizon conserves energy. Full size: cases/plate_wave,
# cases/plate_step.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
none='solid.refinement={from: 1}'
names='FNR == 1 { delete k; for (i = 1; i <= NF; i++) k[$i] = i } FNR <= 2 { next }'

wave() { # wave NAME options...
  local name=$1
  shift
  code 0 ranks 1 run "$source/cases/plate_wave/scene.yaml" --out "$name" --set output.series_every=40 \
    --set output.probes.every=4 --set output.probes.at='[[0.034, 0.02]]' "$@"
}
reflected() { # % of the pulse
  awk -F, "$names"' { u = $k["displacement_x"]; t = $k["t"] }
    FILENAME == ARGV[1] { uniform[t] = u; if (u > top) top = u; next }
    t >= 0.05 { d = u - uniform[t]; if (d < 0) d = -d; if (d > most) most = d }
    END { print 100 * most / top }' uniform/probes.csv "$1/probes.csv"
}
changed() { # % of the uniform grid's energy
  awk -F, "$names"' { e = $k["e_kinetic_solid"] + $k["e_strain"]; t = $k["t"] }
    FILENAME == ARGV[1] { uniform[t] = e; next } { d = 1 - e / uniform[t]; if (d < 0) d = -d; if (d > most) most = d }
    END { print 100 * most }' uniform/series.csv "$1/series.csv"
}
between() { awk "BEGIN { exit !($2 > $1 && $2 < $3) }" || fail "$4 $2, should be between $1 and $3"; }

wave uniform --set "$none"
wave dual
wave b --set solid.horizons=one_sided
between 0.05 "$(reflected dual)" 0.25 "dual horizon reflects" # a tenth of the 2.5 % of 000
between 2.25 "$(reflected b)" 2.75 "one-sided reflects" # a tenth more or less than in 000
between 0 "$(changed dual)" 1e-3 "dual horizon changes the energy by"
between 0.1 "$(changed b)" 0.57 "one-sided changes the energy by"

unbalanced() { # % of the largest energy
  awk -F, "$names"' { e = $k["e_kinetic_solid"] + $k["e_strain"]; d = e - $k["work_load"] - $k["e_constraint"]
      if (e > top) top = e; if (d < 0) d = -d; if (d > most) most = d } END { print 100 * most / top }' "$1/series.csv"
}
for horizons in dual one_sided; do
  code 0 ranks 1 run "$source/cases/plate_step/scene.yaml" --out step_$horizons --set output.series_every=20 \
    --set solid.horizons=$horizons
done
between 0 "$(unbalanced step_dual)" 0.02 "dual horizon makes or loses"
between 0.5 "$(unbalanced step_one_sided)" 7.15 "one-sided makes or loses"
echo ok
