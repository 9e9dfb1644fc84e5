#!/usr/bin/env bash
# The longest stable step of the solid, over stiffness, horizon, damping, damage and contact, compared with the step
# that frana computes.
# usage: cases/stability/solid/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../../verification/common.sh" "$@"
# shellcheck source=cases/stability/edge.sh
. "$here/../edge.sh"
# A run is bounded if the kinetic energy in its last quarter is less than a thousand times that at its start. A step
# 0.3 % above RK3's limit exceeds this after 2000 steps.
# Two particles in contact separate as soon as their oscillation grows. Their run is bounded if the energy stays below
# thirty times that of the first oscillation.
judge() {
  local growth='max(n - n / 4, n) <= 1e3 * max(1, n / 20)'
  ! grep -q 'name: left' "$1/scene.resolved.yaml" || growth='max(1, n) <= 30 * max(1, 3)'
  [ "$(of_run "$1" e_kinetic_solid "print $growth")" = 1 ]
}

both() { # both SCENE LIMIT SETTING...: limits with RK3 and Verlet, and what `frana check` prints for LIMIT
  local scene=$1 limit=$2 method name at row=
  shift 2
  for method in rk3 verlet; do
    case $limit,$method in
      stage,*) name= ;;
      *,rk3) name='solid, bonds, RK3' ;;
      *) name='solid, bonds, velocity Verlet' ;;
    esac
    if [ "$name" ]; then at=$(stable_step "$scene" "$name" "$@"); else \
      at=$(stage_limit "$scene" "$@" stages.0.integrator=$method); fi
    row=$row,$(edge "$(calc "0.5 * $at")" "$(calc "4 * $at")" 0.004 \
      "$scene" "$@" stages.0.integrator=$method stages.0.time_step=@),$at
  done
  echo "${row#,}"
}
stage_limit() { # the limit of a stage with its damping
  local scene=$1 set=() s
  shift
  for s in "$@"; do set+=(--set "$s"); done
  "$frana" check "$here/$scene.yaml" "${set[@]}" | sed -n 's/^  swing .*stable up to \([0-9.e+-]*\) s.*/\1/p'
}
# touch K: RK3's limit, and what `frana check` prints; the longest step that Verlet was tried with, and 2/omega
touch() {
  local set="solid.contact.stiffness=$1" at long
  at=$(stable_step touch 'solid, a broken bond closed, RK3' "$set")
  long=$(calc "20 * $at")
  echo "$(edge "$(calc "0.5 * $at")" "$(calc "4 * $at")" 0.004 touch "$set" stages.0.integrator=rk3 \
    stages.0.time_step=@),$at,$(edge "$at" "$long" 0.004 touch "$set" stages.0.integrator=verlet \
    stages.0.time_step=@),$(calc "2 / sqrt(3) * $at")"
}
planes() { # planes N: a setting with N cracks across the body, along x, y, z in turn
  local k list='' a
  for ((k = 0; k < $1; k++)); do
    a=$((k / 3 + 1))
    case $((k % 3)) in
      0) list="$list, {points: [[$a, -1, -1], [$a, 7, -1], [$a, 7, 7], [$a, -1, 7]]}" ;;
      1) list="$list, {points: [[-1, $a, -1], [7, $a, -1], [7, $a, 7], [-1, $a, 7]]}" ;;
      2) list="$list, {points: [[-1, -1, $a], [7, -1, $a], [7, 7, $a], [-1, 7, $a]]}" ;;
    esac
  done
  echo "solid.cracks=[${list#, }]"
}
point() { # point WHAT AT: WHAT is the quantity that is varied, AT its value
  local what=$1 at=$2
  case $what in
    E) echo "$what,$at,$(both scene bonds solid.materials.0.youngs_modulus="$at")" ;;
    m) echo "$what,$at,$(both scene bonds solid.materials.0.horizon_ratio="$at")" ;;
    damping) echo "$what,$at,$(both scene stage stages.0.damping_relative="$at")" ;;
    absolute) echo "$what,$at,$(both scene stage stages.0.damping_absolute="$at")" ;;
    cracks) echo "$what,$at,$(both scene bonds "$(planes "$at")")" ;;
    contact) echo "$what,$at,$(touch "$at")" ;;
  esac
}
{
  printf 'E %s\n' 1 ${quick:-1e3 1e6 1e9 1e12}
  [ "$quick" ] || printf 'm %s\n' 1 1.5 2 2.5 3 3.5 4 4.49
  [ "$quick" ] || printf 'damping %s\n' 0.001 0.003 0.01 0.02 0.04 0.1 0.3
  [ "$quick" ] || printf 'absolute %s\n' 0.1 0.3 1 2
  [ "$quick" ] || printf 'cracks %s\n' 0 3 6 9 12 14
  printf 'contact %s\n' 15 ${quick:-1 5 50 150}
} | sed '/quick$/d' >"$runs/points"
table limits 'what,at,rk3,rk3_computed,verlet,verlet_computed' <"$runs/points"

while IFS=, read -r what at rk3 of_rk3 verlet of_verlet; do
  for method in RK3 Verlet; do
    found=$rk3 computed=$of_rk3
    [ $method = RK3 ] || found=$verlet computed=$of_verlet
    case $what-$method in
      what-*) ;;
      contact-RK3) # contact that opens as the oscillation grows is softer than its spring: the computed step is a bound
        row "$what = $at, $method: longest step over the computed bound" 1 "$(calc "$found / $computed")" "" \
          "not below it" 0.995 ;;
      contact-Verlet) # implicit, without a limit: the longest step that was tried is stable
        row "$what = $at, $method: longest step over 2/omega of explicit contact" 1 "$(calc "$found / $computed")" "" \
          "no limit" 17 ;;
      # computed from one limit for the whole body, or a polygon around the rates of all modes: a bound
      cracks-* | damping-* | absolute-*)
        row "$what = $at, $method: longest step over the computed bound" 1 "$(calc "$found / $computed")" "" \
          "not below it" 0.995 ;;
      *) near "$what = $at, $method: longest step" s "$found" "$computed" "computed from the largest rates" 0.02 ;;
    esac
  done
done <"$out/limits.csv"
plot limits
finish
