#!/usr/bin/env bash
# Error over cost of steps, substeps, safety, integrator, load and forcing iterations: a block of the main case under a
# flow, a column of fluid on a spring, a notched plate. All of it takes a quarter of an hour of one core.
# usage: cases/verification/cost/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"

if [ "$quick" ]; then of=study_quick; else of=study_first; fi
at() { cell "$of" value 'load by reaction' "$1" "$2"; } # at LEVEL QUANTITY
ratio() { calc "$(at "$1" "$3") / $(at "$2" "$3")"; }   # ratio LEVEL LEVEL QUANTITY
study "$of"
# the first bond at an eighth of the step, and at a quarter within 0.1 % of that
first_bond=8.120e-4
near "first bond, a half of the step" s "$(at 'step / 2' 'first bond')" $first_bond "an eighth of the step" 0.02
near "first bond, the default step" s "$(at default 'first bond')" $first_bond "an eighth of the step" 0.05
near "first bond, 3 substeps over 24" 1 "$(ratio default '24 substeps' 'first bond')" 1 "finer substeps" 0.005
near "first bond, Verlet over RK3 at the same substep" 1 "$(ratio default rk3 'first bond')" 1 "third order" 0.005
near "drag of the hold, the default step over a half" 1 "$(ratio default 'step / 2' drag)" 1 "a finer step" 0.001
[ ! "$quick" ] || { finish; exit; }

near "first bond, a quarter of the step" s "$(at 'step / 4' 'first bond')" $first_bond "an eighth of the step" 0.005
for name in broken scatter settled scatter_settled hold column notch economical multistep; do study "study_$name"; done

column() { # column METHOD LEVEL: the frequency over that of reaction and Verlet at a quarter of the step
  calc "$(cell study_column value "$1" "$2" frequency) / $(cell study_column value reaction 'step / 4' frequency)"
}
near "column, 315 steps a period: frequency over that at four times as many" 1 \
  "$(column reaction default)" 1 "a finer step" 0.01
near "column, 315 steps a period: frequency by Verlet over RK3" 1 \
  "$(calc "$(column reaction default) / $(column 'reaction rk3' default)")" 1 "third order" 0.005

# broken STUDY METHOD LEVEL QUANTITY LEVEL: the number at a level over that at the last one
broken() { calc "$(cell "$1" value "$2" "$3" "$4") / $(cell "$1" value "$2" "$5" "$4")"; }
for name in scatter scatter_settled; do
  same "$name: bonds broken with the inflow changed by 1e-12" 1 \
    "$(cell study_$name value inflow 1e-12 'share broken at 4.8 ms')" \
    "$(cell study_$name value inflow 0 'share broken at 4.8 ms')" "round-off is not amplified"
  shown "$name: bonds broken with the inflow changed by 1e-4, over those without" 1 \
    "$(broken study_$name inflow 1e-4 'share broken at 4.8 ms' 0)" 1 "scatter"
done
for name in broken settled; do
  near "$name: share at 4.8 ms, default over 12 substeps" 1 \
    "$(broken study_$name 'load by reaction' default 'share broken at 4.8 ms' '12 substeps')" 1 "finer substeps" 0.03
  shown "$name: share at 4.8 ms, default over a quarter of the step" 1 \
    "$(broken study_$name 'load by reaction' default 'share broken at 4.8 ms' 'step / 4')" 1 "a finer step"
done
advised='settled by steps x 2 broken by / 3'
near "settled by twice and broken by a third of the step: time of 1 % of the bonds over that at a quarter" 1 \
  "$(broken study_settled 'load by reaction' "$advised" '1 % of the bonds' 'step / 4')" 1 "a finer step" 0.01
near "settled by twice and broken by a third of the step: share at 4.8 ms over that at a quarter" 1 \
  "$(broken study_settled 'load by reaction' "$advised" 'share broken at 4.8 ms' 'step / 4')" 1 "a finer step" 0.02
# as many steps of breaking: what one projection, mixed precision and longer steps of settling change together
both() { broken study_economical 'load by reaction' economical "$1" default; } # both QUANTITY
near "economical settings: drag over that of the default" 1 "$(both drag)" 1 "the default" 0.01
near "economical settings: time of 1 % of the bonds over that of the default" 1 \
  "$(both '1 % of the bonds')" 1 "the default" 0.01
for at in 0.8 2.4 4.8; do
  near "economical settings: share broken at $at ms over that of the default" 1 \
    "$(both "share broken at $at ms")" 1 "the default" 0.02
done
# Adams and Bashforth's scheme, over RK3 at a quarter of the step
for part in 3 4; do
  level="AB2 settled by steps x 2 broken by / $part" name="AB2, settled by twice and broken by 1/$part of the step"
  near "$name: drag over that of RK3 at a quarter" 1 \
    "$(broken study_multistep 'load by reaction' "$level" drag 'RK3 step / 4')" 1 "a finer step" 0.01
  near "$name: time of 1 % of the bonds over that of RK3 at a quarter" 1 \
    "$(broken study_multistep 'load by reaction' "$level" '1 % of the bonds' 'RK3 step / 4')" 1 "a finer step" 0.01
  for at in 0.8 2.4 4.8; do
    near "$name: share broken at $at ms over that of RK3 at a quarter" 1 \
      "$(broken study_multistep 'load by reaction' "$level" "share broken at $at ms" 'RK3 step / 4')" 1 \
      "a finer step" 0.02
  done
done
near "drag of the hold, all of the flow at twice the step over that at the default step" 1 \
  "$(broken study_hold reaction 'step x 2' drag default)" 1 "a finer step" 0.002
near "notched plate: area of cracks, default over safety 0.1" 1 \
  "$(broken study_notch brittle default 'area of cracks' 'safety 0.1')" 1 "finer steps" 0.03

# cost.csv: each run of the block with its steps, sweeps, counted cost and relative errors
costs() { # costs STUDY FROM: FROM is when the solid becomes elastic, s
  local method level folder
  sed '/^#/d; /^method,level/d' "$runs/$1.csv" | cut -d, -f1,2 | awk '!seen[$0]++' |
    while IFS=, read -r method level; do
      folder=$runs/runs/$1/$(printf '%s\n' "$method" "$level" | tr -c 'A-Za-z0-9._\n' - | paste -sd /)/1
      is_done "$folder" || continue
      printf '%s,%s,%s,' "$1" "$method" "$level"
      awk -v from="$2" -f "$here/cost.awk" "$folder/run.json" "$folder/scene.resolved.yaml" "$folder/series.csv"
    done
}
costed() { # costed STUDY FROM: the same with each quantity's value and relative error
  costs "$@" >"$runs/$1.costs"
  awk -F, -v study="$1" 'FNR == NR { cost[$2 "," $3] = $4 "," $5 "," $6; next } /^#/ { next }
    !at { for (i = 1; i <= NF; i++) k[$i] = i; at = 1; next }
    ($1 "," $2) in cost { print study "," $1 "," $2 "," $k["quantity"] "," $k["value"] "," $k["relative_error"] "," \
      cost[$1 "," $2] }' "$runs/$1.costs" "$runs/$1.csv"
}
if [ ! "$again" ]; then
  # cost.csv and cost.png stand for the studies' own pages and plots, whose seconds are of a machine that did other work
  rm -f "$out"/study_*.md "$out"/study_*.png
  sed -i '/^# advice on /d' "$out"/study_*.csv
  { echo study,method,level,quantity,value,relative_error,steps,sweeps,counted_s
    costed study_first 0.038403
    costed study_broken 0.038403
    costed study_scatter 0.038403
    costed study_settled 0.033569
    costed study_scatter_settled 0.033569
    costed study_multistep 0.033569
    costed study_hold 0; } >"$out/cost.csv"
  if command -v gnuplot >/dev/null; then gnuplot -e "folder = '$out'" "$here/cost.gp"; fi
fi
finish
