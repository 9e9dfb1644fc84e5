#!/usr/bin/env bash
# A file of gates: its studies, runs and measured numbers; every rule; names and groups; what is judged again without a
# run; misses that are known; mistakes.
# usage: gates.sh FRANA SOURCE WORK
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/../common.sh" "$@"
mkdir case && cd case
cat >scene.yaml <<'END'
title: Two particles that fly
domain: {size: [0.016, 0.004, 0.004]}
solid:
  spacing: 1.0e-3
  materials: [{name: any, youngs_modulus: 1.0e8, density: 3000}]
  bodies: [{name: bar, shape: box, low: [0, 0, 0], high: [0.002, 0.001, 0.001], velocity: [2, 0, 0]}]
stages: [{name: fly, steps: 10, time_step: 1.0e-6}]
output: {series_every: 5, fields_every: 0, checkpoint_every: 0}
END
cat >study.yaml <<'END'
scene: scene.yaml
repeats: 1
quantities:
  - {name: energy, column: e_kinetic_solid, unit: J, reference: {value: 1.2e-5}} # 6e-6 kg at 2 m/s
  - {name: "time, last", column: t, unit: s, reference: {value: 1.0e-5}}
methods: [{name: slow}, {name: fast, set: {stages.fly.time_step: 2.0e-6}}]
levels: [{name: "10"}, {name: "20", set: {stages.fly.steps: 20}}]
END
sed 's/time_step: 2.0e-6/time_step: 4.0e-6/' study.yaml >study_long.yaml
cat >gates.yaml <<'END'
digits: 6
studies: [{name: study}, {name: study_long, when: whole}]
runs:
  - {each: {steps: [3, 7]}, name: "alone {steps}", scene: scene.yaml, set: {stages.fly.steps: "{steps}"}}
  - command: wc -l <"alone 3/series.csv" >lines.txt
measured:
  - each: {steps: [3, 7]}
    key: time of {steps}
    command: tail -n 1 "alone {steps}/series.csv" | cut -d, -f2
  - each: {row: [1, 2]}
    key: row {row}
    file: alone 7/series.csv
    column: t
    row: "{row}"
  - {key: last, file: alone 7/series.csv, column: t, factor: 2}
  - {key: first, file: alone 7/series.csv, column: t, at: first}
  - {key: at 5, file: alone 7/series.csv, column: "1e6 * [t] + [step]", where: step = 5}
  - {key: least, file: alone 7/series.csv, column: "[step] - 10", at: min}
  - {key: sum, value: "[at 5] + [time of 7] * 1e6"}
  - {key: lines, command: cat lines.txt}
  - {key: made, file: made.csv, quantity: b}
  - key: folder
    command: basename "$FRANA_STUDY"; "$FRANA" --version | sed -n 's/^frana .*/yes/p'
files:
  - command: printf '1\n' >"$FRANA_RESULTS/extra.csv"
gates:
  - each: [{method: [slow, fast], step: [1, 2]}, {level: [10, 20]}]
    quantity: "{method}, {level} steps: energy"
    unit: J
    ours: "[study|{method}|{level}|energy]"
    reference: 1.2e-5
    source: m v^2/2
    relative: 1e-12
  - source: steps times the step
    unit: s
    gates:
      - each: {method: [slow, fast], step: [1, 2]}
        gates:
          - {quantity: "{method}: last time", ours: "[study|{method}|20|time, last]",
             reference: "[study|slow|10|time, last] * 2 * {step}", relative: 1e-12}
          - {quantity: "{method}: it grows", unit: 1, between: [1.9, 2.1],
             ours: "[study|{method}|20|time, last] / [study|{method}|10|time, last]"}
      - {quantity: long, ours: "[study_long|fast|20|time, last]", at_least: 8e-5, when: whole}
      - {quantity: alone, ours: "[time of 7] - [time of 3]", at_most: 4.1e-6}
  - {quantity: program, ours: "[folder]", reference: "yes", same: true}
  - {quantity: rows, ours: "[last] / min([row 1], [row 2], 1)", reference: 2.8, relative: 1e-9} # twice 7 us over 5 us
  - {quantity: a table's quantity, ours: "[made]", reference: 4, relative: 1e-9}
  - {quantity: rows of a condition, ours: "[at 5]", reference: 10, relative: 1e-9} # 5 us and step 5
  - {quantity: arithmetic, ours: "[sum] + 1e6 * [first]", reference: 22, relative: 1e-9}
  - {quantity: "least, and lines", ours: "[least] * [lines]", reference: -15, relative: 1e-9} # step 5; head and step 3
  - {quantity: a measured limit, ours: "[last]", between: ["[row 1]", 1]} # 5 us
  - {quantity: error, ours: "[study|slow|10|energy|reference]"}
END
mkdir runs && printf 'quantity,value\na,3\nb,4\n' >runs/made.csv
code 0 "$frana" study gates.yaml --out runs
cat >expected <<'END'
quantity,unit,ours,reference,source,tolerance,pass
"slow, 10 steps: energy",J,1.2e-05,1.2e-05,m v^2/2,1e-12 relative,yes
"slow, 20 steps: energy",J,1.2e-05,1.2e-05,m v^2/2,1e-12 relative,yes
"fast, 10 steps: energy",J,1.2e-05,1.2e-05,m v^2/2,1e-12 relative,yes
"fast, 20 steps: energy",J,1.2e-05,1.2e-05,m v^2/2,1e-12 relative,yes
slow: last time,s,2e-05,2e-05,steps times the step,1e-12 relative,yes
slow: it grows,1,2,,steps times the step,1.9 to 2.1,yes
fast: last time,s,4e-05,4e-05,steps times the step,1e-12 relative,yes
fast: it grows,1,2,,steps times the step,1.9 to 2.1,yes
long,s,8e-05,,steps times the step,>= 8e-5,yes
alone,s,4e-06,,steps times the step,at most 4.1e-6,yes
program,1,yes,yes,,the same,yes
rows,1,2.8,2.8,,1e-09 relative,yes
a table's quantity,1,4,4,,1e-09 relative,yes
rows of a condition,1,10,10,,1e-09 relative,yes
arithmetic,1,22,22,,1e-09 relative,yes
"least, and lines",1,-15,-15,,1e-09 relative,yes
a measured limit,1,1.4e-05,,,5e-06 to 1,yes
END
diff expected results/summary.csv || fail "another summary"
printf 'quantity,unit,ours,reference,source\nerror,1,1.2e-05,,\n' | diff - results/shown.csv || fail "another shown.csv"
[ "$(cut -d, -f1 results/measured.csv | paste -sd' ')" = \
  '"time of 3" "time of 7" "row 1" "row 2" "last" "first" "at 5" "least" "sum" "lines" "made" "folder"' ] ||
  fail "$(cat results/measured.csv)"
[ -s results/extra.csv ] || fail "no extra.csv in the results"
for file in study.csv study.md study_long.csv; do [ -s results/$file ] || fail "no $file in the results"; done

# judged again from the results alone
mv runs away
mv results/summary.csv before
echo precious >outside && ln -s ../outside results/summary.csv
code 0 "$frana" study gates.yaml --collect
[ "$(cat outside)" = precious ] || fail "a summary is written through a link"
cmp before results/summary.csv || fail "--collect gives another summary"
[ ! -e runs ] || fail "--collect has made a run"

# a miss: exit code 1; known, it does not count elsewhere or when quick, and one that is new does
sed 's/between: \[1.9/between: [2.05/' gates.yaml >miss.yaml
code 1 "$frana" study miss.yaml --collect
grep -c ',no$' results/summary.csv | grep -qx 2 || fail "not two misses"
mkdir ../quick && printf 'quantity,value\nb,4\n' >../quick/made.csv
code 0 "$frana" study miss.yaml --out ../quick --results ../quick_results --quick
grep -q '^long,' ../quick_results/quick.csv && fail "quick judges what is for the whole"
[ ! -e ../quick/study_long.csv ] && [ ! -e ../quick_results/study.csv ] || fail "quick makes too much"
sed -i 's/at_most: 4.1e-6/at_most: 3.9e-6/' miss.yaml
code 1 "$frana" study miss.yaml --out ../quick --results ../quick_results --quick
grep -q 'missed here, met in results/summary.csv: alone' err || { cat err >&2; fail "the new miss is not named"; }

# refused CODE SENTENCE SED: the file, changed by sed, is refused with the sentence
refused() {
  sed "$3" gates.yaml >bad.yaml
  code "$1" "$frana" study bad.yaml --collect
  grep -qF -- "$2" err || { cat err >&2; fail "not said: $2"; }
}
refused 2 'at_mots = 4.1e-6: unknown key; did you mean at_most?' \
  's/at_most/at_mots/; s/^      - {quantity: alone/  - {quantity: alone/'
refused 2 'each: must be a mapping of names to lists of values of one length' 's/step: \[1, 2\]/step: [1]/'
refused 2 'a gate needs a number in brackets' 's/ours: "\[folder\]"/ours: "5"/'
refused 2 'one rule, and not both relative and same' 's/same: true/same: true, relative: 1/'
refused 2 'between must be a list of two numbers' 's/\[1.9, 2.1\]/[1.9]/'
refused 2 'something follows the arithmetic' 's/- \[time of 3\]/[time of 3]/'
printf 'gates: [{quantity: a, ours: {b}\n' >bad.yaml
code 2 "$frana" study bad.yaml --collect --results results
grep -q 'bad.yaml:.*not valid YAML' err || { cat err >&2; fail "a file that is no YAML"; }
refused 4 '[study|slow|30|energy|reference]: is not in' 's/slow|10|energy|ref/slow|30|energy|ref/'
refused 4 '[time of 9]: is not in' 's/time of 7\] -/time of 9] -/'
refused 2 'when = never: must be one of quick, whole' 's/when: whole/when: never/'
code 2 "$frana" study study.yaml --quick
grep -q 'go with a file of gates only' err || fail "a study that is quick"
code 2 "$frana" study gates.yaml --list
grep -q 'has gates; give one of its studies' err || fail "a list of gates"
# not_measured SENTENCE SED: as refused, by what is measured
not_measured() {
  sed "$2" gates.yaml >bad.yaml
  code 4 "$frana" study bad.yaml --out ../quick --quick
  grep -qF -- "$1" err || { cat err >&2; fail "not said: $1"; }
}
not_measured 'has no column tt; did you mean' 's/column: t,/column: tt,/'
not_measured 'alone 7/series.csv: has no such row' 's/row: \[1, 2\]/row: [1, 4]/'
not_measured 'has no quantity c' 's/quantity: b}/quantity: c}/'
sed 's/command: basename/command: exit 3; basename/' gates.yaml >bad.yaml
code 4 "$frana" study bad.yaml --out ../quick --quick
grep -q 'a command ended with exit code' err || { cat err >&2; fail "a command that fails"; }
echo ok
