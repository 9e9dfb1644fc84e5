#!/usr/bin/env bash
# Builds the fuzz targets with clang, libFuzzer, ASan and UBSan, runs each on its corpus and prints a table.
# usage: tests/fuzz/run.sh [-n EXECUTIONS] [-t SECONDS] [-b FOLDER] [TARGET ...]
#   -n  executions of each target (default 1000000)     -t  seconds at most for each (default 3600)
#   -b  folder for the build and the results (default build-fuzz); its found/TARGET keeps inputs that reach new code
#       for the next run; crash-* and similar files are failing inputs. Good inputs are copied to tests/fuzz/corpus.
# BUSY: a command through which builds and runs are started (default: none).
set -euo pipefail
source=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
executions=1000000 seconds=3600 build=$source/build-fuzz
while getopts n:t:b: option; do
  case $option in
  n) executions=$OPTARG ;;
  t) seconds=$OPTARG ;;
  b) build=$OPTARG ;;
  *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
[ $# -gt 0 ] || set -- scene study points spheres checkpoint mhd nrrd tiff hdf5
busy=${BUSY:-}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_opal_signal=
# recording the stacks of allocations would take half of the time; a crash can be repeated with them
export ASAN_OPTIONS=allocator_may_return_null=1:malloc_context_size=0 UBSAN_OPTIONS=print_stacktrace=1

$busy cmake -S "$source" -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_BUILD_TYPE=Debug -DFRANA_SANITIZE=ON \
  -DFRANA_FUZZ=ON >/dev/null
$busy ninja -C "$build" "${@/#/fuzz_}" >"$build/build.log" || { tail -n 20 "$build/build.log"; exit 1; }
failed=0
printf '%-12s %12s %8s %10s %8s %8s  %s\n' target executions seconds per_second edges corpus result
for target; do
  found=$build/found/$target log=$build/found/$target.log
  mkdir -p "$found"
  begin=$(date +%s) result=fine
  $busy "$build/tests/fuzz/fuzz_$target" -runs="$executions" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -max_len=8192 -reload=0 -print_final_stats=1 -artifact_prefix="$build/found/$target-" "$found" \
    "$source/tests/fuzz/corpus/$target" >"$log" 2>&1 || { result="FAILED: $log" failed=1; }
  took=$(($(date +%s) - begin))
  runs=$(awk '/stat::number_of_executed_units/ { print $2; exit }' "$log")
  edges=$(grep -o 'cov: [0-9]*' "$log" | tail -n 1 | cut -d' ' -f2 || true)
  printf '%-12s %12s %8s %10s %8s %8s  %s\n' "$target" "${runs:-?}" "$took" "$((${runs:-0} / (took > 0 ? took : 1)))" \
    "${edges:-?}" "$(find "$found" -type f | wc -l)" "$result"
done
exit $failed
