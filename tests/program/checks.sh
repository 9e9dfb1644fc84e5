#!/usr/bin/env bash
# The scenes of cases/ pass frana check; no lattice point lies on a surface unless the scene says that it is meant. By
# day one scene of every second folder, and those whose check takes seconds at twice their spacing; tests/scene/keys/
# test_describe.c has the keys of all. At night every scene as it is.
# usage: checks.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
cases=$source/cases porous=$source/cases/porous_channel/s1.yaml
printf "$cases/verification/%s.yaml\n" borehole/scene calibration/plate element_free/mixed hydraulic_fracture/penny \
  hydraulic_fracture/penny_viscosity impact_disc/scene parallel_cracks/scene >large

# scene_checks FILE: checks one scene, in a folder of its own
scene_checks() {
  local file=$1 here=$PWD/scene.$BASHPID text says coarser=()
  mkdir "$here"
  if ! thorough && [[ $'\n'$large$'\n' == *$'\n'$file$'\n'* ]]; then
    coarser=(--set "solid.spacing=$(awk '$1 == "spacing:" { print 2 * $2; exit }' "$file")")
  fi
  cd "$here"
  code 0 ranks 1 check "$file" "${coarser[@]}"
  text=$'\n'$(<"$file") says=$(<out)
  [[ $file != "$porous" || $says == *' 54576 particles'* ]] || fail "the main case has another number of particles"
  if [[ $text == *$'\n'nonlocal:* || $text == *'method: element_free'* ]]; then # solved at once
    [[ $says == *unknowns* ]] || fail "$file: no unknowns"
    return
  fi
  [[ $says == *'leaves out'* ]] || fail "$file: nothing said of what is left out"
  [[ $says == *'stable steps'* ]] || fail "$file: no stable steps"
  [[ $says != *'lie on'* || $text == *'lies on an edge is inside'* ]] || fail "$file: $(grep 'lie on' out)"
}
export -f scene_checks code ranks fail thorough
large=$(<large)
export frana porous large

# but those that lack a file, which the case's command makes, or which is not in here
find "$cases" -name '*.yaml' ! -path '*/results/*' ! -name 'study*.yaml' ! -name gates.yaml \
  -exec grep -LE 'file: [a-z0-9_.]*\.(txt|raw|tif)' {} + | sort >all
grep -xFf large all >there || true
cmp -s large there || fail "not all large scenes are there"
# of a folder the scene that is called so, or the first one
thorough || awk -F/ '{ name = $NF; sub("/[^/]*$", ""); if (!($0 in one) || name ~ /^(scene|s1)\.yaml$/) one[$0] = name }
  END { for (folder in one) print folder "/" one[folder] }' all >day
thorough || { sort day | awk 'NR % 2'; cat large; echo "$porous"; } | sort -u >all
count=$(wc -l <all)
[ "$count" -ge 4 ] || fail "only $count scenes"
# two at a time
xargs -P 2 -n 3 bash -euo pipefail -c 'for file; do (scene_checks "$file"); done' _ <all || fail "not all scenes pass"
[ "$(find . -name out | wc -l)" = "$count" ] || fail "not all scenes were checked"
echo "$count scenes"

# Cavities of 9.15 cells pass through lattice points, as does a region that ends in a layer of a bar's particles.
counts() { # counts COUNT WHAT: the warning counts so many
  grep -q "warning: $1 .* lie on the $2.* count as inside" out || fail "not $1 on the $2: $(grep 'lie on' out)"
}
demo=$cases/porous_channel/demo.yaml
[ -f "$porous" ] && [ -f "$demo" ] || fail "no $porous or $demo"
code 0 ranks 2 check "$demo" --set solid.bodies.block.cavities.radius=0.014296875
counts 64 'surface of block'
grep -q ' 9456 particles' out || fail "points on the cavities' surface are not inside"
code 0 ranks 1 check "$source/cases/bar/scene.yaml" --set 'solid.constraints[0].high=[0.0025, 0.01, 0.01]'
counts 100 'border of solid.constraints\[0\]'
