#!/usr/bin/env bash
# A part that a scene leaves out takes no memory and no time.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
scene >whole.yaml
# without solid, without fluid
awk '/^(solid|coupling):/ { skip = 1 } /^(fluid|stages|output|domain|title):/ { skip = 0 } !skip' whole.yaml |
  sed -e '/name: settle/d; /name: fracture/d; s/, solid: rigid//' >fluid.yaml
awk '/^(fluid|coupling):/ { skip = 1 } /^(solid|stages|output|domain|title):/ { skip = 0 } !skip' whole.yaml |
  sed -e '/name: flow/d' -e 's/^  cells: .*/  periodic: [false, false, true]/' \
    -e '/^solid:/a\  spacing: 1.5625e-3' >solid.yaml
sed -e '/name: settle/d; /name: fracture/d' whole.yaml >rigid.yaml
value() { sed -n "s/.*\"$2\": *\([-0-9.e+]*\).*/\1/p" "$1/run.json" | head -n 1; }
memory() { sed -n '/"memory_bytes_by_part"/,/}/p' "$1/run.json" | sed -n "s/.*\"$2\": *\([-0-9.e+]*\).*/\1/p"; }
for name in whole fluid solid rigid; do code 0 ranks 1 run $name.yaml --out $name; done

zero() { awk -v v="$2" 'BEGIN { exit !(v + 0 == 0) }' || fail "$1 is $2, not 0"; }
less() { awk -v a="$2" -v b="$3" 'BEGIN { exit !(a + 0 <= b + 0) }' || fail "$1: $2 is more than $3"; }
for part in forcing probe solid contact interface; do zero "fluid alone: $part" "$(value fluid $part)"; done
for part in solid ibm coupling; do zero "fluid alone: memory of $part" "$(memory fluid $part)"; done
for part in momentum poisson halo forcing probe interface; do zero "solid alone: $part" "$(value solid $part)"; done
for part in fluid ibm; do zero "solid alone: memory of $part" "$(memory solid $part)"; done
for part in solid contact; do zero "rigid: $part" "$(value rigid $part)"; done
# memory of the part itself: a fluid has 10 arrays and the work of the Poisson solver, with one ghost layer
less "fluid alone: bytes a cell" "$(memory fluid fluid)" "$((40 * 18 * 18 * 8 * 14))" # rows are padded to cache lines
less "a fluid alone against one with something in it" "$(memory fluid fluid)" "$(memory whole fluid)"
less "solid alone against the whole" "$(memory solid solid)" "$(memory whole solid)"
less "a rigid solid against an elastic one" "$(memory rigid solid)" "$(($(memory whole solid | cut -d. -f1) * 3 / 4))"
grep -q '"fluid: the scene has no section fluid"' solid/run.json ||
  fail "run.json does not say that the fluid is left out"
grep -q '"solid: the scene has no section solid"' fluid/run.json ||
  fail "run.json does not say that the solid is left out"
grep -q 'bonds: the solid is rigid' rigid/run.json || fail "run.json does not say that the bonds are left out"
[ ! -e fluid/fields/solid.hdf.series ] || fail "a fluid alone has written solid fields"
[ ! -e solid/fields/fluid.hdf.series ] || fail "a solid alone has written fluid fields"
grep -q 'strong coupling: coupling.scheme is explicit' whole/run.json ||
  fail "run.json does not say that nothing is iterated"
head -n 1 fluid/series.csv | grep -qE 'porosity|bonds' && fail "a fluid alone has columns of the solid"
head -n 1 solid/series.csv | grep -qE 'cfl|dp' && fail "a solid alone has columns of the fluid"
echo ok
