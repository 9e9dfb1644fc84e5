#!/usr/bin/env bash
# Every scene of cases/ passes frana check.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
count=0
for file in $(find "$source/cases" -name '*.yaml' ! -path '*/results/*' ! -name 'study*.yaml' | sort); do
  ! grep -q 'file: [a-z_]*\.txt' "$file" || continue # files that the case's command makes
  code 0 ranks 1 check "$file"
  grep -q 'leaves out' out || fail "$file: nothing said of what is left out"
  grep -q 'stable steps' out || fail "$file: no stable steps"
  count=$((count + 1))
done
[ $count -ge 5 ] || fail "only $count scenes"
echo "$count scenes"
