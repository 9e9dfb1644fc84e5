#!/usr/bin/env bash
# Every scene of cases/ passes frana check; no lattice point lies on a surface unless the scene says that it is meant.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
count=0 porous=$source/cases/porous_channel/s1.yaml
for file in $(find "$source/cases" -name '*.yaml' ! -path '*/results/*' ! -name 'study*.yaml' | sort); do
  ! grep -Eq 'file: [a-z0-9_.]*\.(txt|raw|tif)' "$file" || continue # made by the case's command, or not in here
  code 0 ranks 1 check "$file"
  count=$((count + 1))
  [ "$file" != "$porous" ] || grep -q ' 54576 particles' out || fail "the main case has another number of particles"
  if grep -Eq '^nonlocal:|method: element_free' "$file"; then # solved at once
    grep -q 'unknowns' out || fail "$file: no unknowns"
    continue
  fi
  grep -q 'leaves out' out || fail "$file: nothing said of what is left out"
  grep -q 'stable steps' out || fail "$file: no stable steps"
  ! grep -q 'lie on' out || grep -q 'lies on an edge is inside' "$file" || fail "$file: $(grep 'lie on' out)"
done
[ $count -ge 5 ] || fail "only $count scenes"
echo "$count scenes"

# Cavities of 9.15 cells pass through lattice points, as does a region that ends in a layer of a bar's particles.
on() { # on COUNT WHAT: the warning counts so many
  grep -q "warning: $1 .* lie on the $2.* count as inside" out || fail "not $1 on the $2: $(grep 'lie on' out)"
}
[ -f "$porous" ] || fail "no $porous"
code 0 ranks 2 check "$porous" --set solid.bodies.block.cavities.radius=0.014296875
on 384 'surface of block'
grep -q ' 54960 particles' out || fail "points on the cavities' surface are not inside"
code 0 ranks 1 check "$source/cases/bar/scene.yaml" --set 'solid.constraints[0].high=[0.0025, 0.01, 0.01]'
on 100 'border of solid.constraints\[0\]'
