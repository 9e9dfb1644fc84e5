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
# The timeline: the parts add up to the wall time, the spans to the parts, and nobody waits longer than a part takes.
# There is a key a line. Of two ranks also each one is told apart.
code 0 ranks 2 run whole.yaml --out both
for name in whole fluid solid rigid both; do
  awk -v name=$name -v FS='[":, ]+' '
    function number() { match($0, /-?[0-9.]+(e[-+][0-9]+)?,?$/); return substr($0, RSTART) + 0 }
    function close_to(a, b, what) {
      if ((a - b) ^ 2 > (0.01 * b + 0.01) ^ 2) { print "FAILED: " name ": " what ": " a " and " b; bad = 1 }
    }
    /^  "wall_seconds":/ { wall = number() }
    /^  "setup_seconds":/ { setup = number() }
    /^  "ranks":/ { ranks = number() }
    /^  "steps":/ { steps = number() }
    /^  ["}]/ { block = $2 }
    block == "wall_seconds_by_part" && /^    "/ { of_part[$2] = number(); sum += number() }
    block == "setup_seconds_by_phase" && /^    "/ && $2 != "launch" && $2 != "scene" { phases += number() }
    block == "seconds_by_part_and_rank" && /^    "/ { part = $2 }
    block == "seconds_by_part_and_rank" && /^          [0-9]/ { each[part] += number(); shown++ }
    block == "seconds_by_part_and_rank" && /"(least|mean|most)":/ && number() < 0 { negative = 1 }
    block == "timeline" && /^      "span":/ { spans++ }
    block == "timeline" && /^      "steps":/ { span_steps += number() }
    block == "timeline" && /^      "seconds":/ { span_sum += number() }
    block == "timeline" && /^      "/ { kind = $2 }
    block == "timeline" && kind ~ /^(working|waiting)$/ && /^        "/ {
      in_spans[$2] += number()
      if (number() < 0) negative = 1
    }
    END {
      close_to(sum, wall, "all parts and the wall time")
      close_to(span_sum, wall, "all spans and the wall time")
      close_to(phases, setup, "the phases and the set-up")
      for (p in of_part) {
        if (of_part[p] == 0) continue
        close_to(in_spans[p], of_part[p], p " in the spans and in the run")
        close_to(each[p] / ranks, of_part[p], p " of the ranks and their mean")
      }
      if (negative) { print "FAILED: " name ": seconds below 0"; bad = 1 }
      if (span_steps != steps) { print "FAILED: " name ": " span_steps " steps of " steps; bad = 1 }
      if (spans < 3 || shown < 2 * ranks) { print "FAILED: " name ": " spans " spans, " shown " numbers"; bad = 1 }
      exit bad
    }' $name/run.json >&2 || fail "the timeline of $name"
done
head -n 1 fluid/series.csv | grep -qE 'porosity|bonds' && fail "a fluid alone has columns of the solid"
head -n 1 solid/series.csv | grep -qE 'cfl|dp' && fail "a solid alone has columns of the fluid"
echo ok
