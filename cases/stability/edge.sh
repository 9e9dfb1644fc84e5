# shellcheck shell=bash
# shellcheck disable=SC2154 # frana, here, runs, out, quick, again: of cases/verification/common.sh
# What the maps share, besides cases/verification/common.sh: a run is judged stable or not, and the limit between stable
# and unstable settings is found by bisection. Limits and points are stored in RUNS by program, scene and settings. A
# map that was stopped continues from them.
if [ "$again" ]; then # maps are not made again; their tables in OUT are judged again
  build='' runs=$(mktemp -d)
  trap 'rm -rf "$runs"' EXIT
else
  build=$("$frana" --version)
fi
export LC_ALL=C OMP_NUM_THREADS=1

# of_run DIR COLUMN COMMAND: runs COMMAND, awk code that may use n, t[] and x[], on a column of the run's series.
of_run() {
  awk -F, -v column="$2" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } NR > 2 { t[++n] = $2;
    x[n] = $at[column] }
    function max(from, to,  k, m) { for (k = from; k <= to; k++) { y = x[k] < 0 ? -x[k] : x[k];
      if (y > m || y != y) m = y } return m }
    END { '"$3"' }' "$1/series.csv"
}
# made DIR SCENE SETTING...: runs SCENE. Returns 1 if the run is unstable; exits if it fails otherwise.
made() {
  local dir=$1 scene=$2 code=0 set=() s
  shift 2
  for s in "$@"; do set+=(--set "$s"); done
  rm -rf "$dir"
  mkdir -p "$(dirname "$dir")"
  "$frana" run "$here/$scene.yaml" --out "$dir" --quiet "${set[@]}" >"$dir.log" 2>&1 || code=$?
  case $code in
    0) return 0 ;;
    3) return 1 ;;
    *) cat "$dir.log" >&2; exit 2 ;;
  esac
}
# holds DIR SCENE SETTING...: whether the run ends and the map's own function `judge DIR` accepts it.
holds() { made "$@" && judge "$1"; }

# edge GOOD BAD WITHIN SCENE SETTING...: the limit of the value that replaces @ in the settings, by bisection between
# GOOD, which should hold, and BAD. Prints the middle of the last interval, whose ends have a ratio of at most
# 1 + WITHIN. Prints BAD if BAD holds too, and nan if GOOD does not hold.
edge() {
  local good=$1 bad=$2 within=$3 scene=$4 key kept dir mid
  key=$(printf '%s\n' "$build" "$(declare -f judge)" "$scene" "$(cat "$here/$scene.yaml")" "$@" | cksum | tr -d ' ')
  kept=$runs/edges/$key dir=$runs/at/$key
  shift 4
  if [ ! -f "$kept" ]; then
    mkdir -p "$runs/edges"
    if ! holds "$dir" "$scene" "${@//@/$good}"; then
      mid=nan
    elif holds "$dir" "$scene" "${@//@/$bad}"; then
      mid=$bad
    else
      while [ "$(calc "(($good > $bad ? $good / $bad : $bad / $good) > 1 + $within)")" = 1 ]; do
        mid=$(calc "sqrt($good * $bad)")
        if holds "$dir" "$scene" "${@//@/$mid}"; then good=$mid; else bad=$mid; fi
      done
      mid=$(calc "sqrt($good * $bad)")
    fi
    rm -rf "$dir" "$dir.log"
    echo "$mid" >"$kept"
  fi
  cat "$kept"
}
# stable_step SCENE NAME SETTING...: the stable step that `frana check` prints in the line NAME.
stable_step() {
  local scene=$1 name=$2 set=() s
  shift 2
  for s in "$@"; do set+=(--set "$s"); done
  "$frana" check "$here/$scene.yaml" "${set[@]}" | sed -n "s/^  $name  *\([0-9.e+-]*\)\$/\1/p"
}
# kept_point ARGUMENT...: the output of the map's function `point`, computed once and stored.
kept_point() {
  local kept
  kept=$runs/points_found/$(printf '%s\n' "$build" "$(declare -f point judge || true)" "$(cat "$here"/*.yaml)" "$@" |
    cksum | tr -d ' ')
  if [ ! -f "$kept" ]; then
    mkdir -p "$runs/points_found"
    point "$@" >"$kept.part"
    mv "$kept.part" "$kept"
  fi
  cat "$kept"
}
# table NAME HEADER: calls the map's function `point` for each line of arguments on standard input, two at a time.
# Writes NAME.csv in the order of the lines.
table() {
  local i=0 args
  [ ! "$again" ] || return 0
  mkdir -p "$runs/rows"
  rm -f "$runs/rows/$1".*
  while read -r args; do
    i=$((i + 1))
    while [ "$(jobs -rp | wc -l)" -ge 2 ]; do wait -n; done
    (kept_point $args >"$runs/rows/$1.$(printf %03d $i)" </dev/null) &
  done
  wait
  { echo "$2"; cat "$runs/rows/$1".*; } >"$out/$1.csv"
  [ "$(wc -l <"$out/$1.csv")" -gt "$i" ] || { echo "$1: points are missing" >&2; exit 1; }
}
# in_table NAME A B COLUMN: a column of the row of NAME.csv whose first two are A and B
in_table() { awk -F, -v a="$2" -v b="$3" -v c="$4" '$1 == a && $2 == b { print $c }' "$out/$1.csv"; }
# plot NAME: draws NAME.png by the map's NAME.gp. Does nothing without gnuplot.
plot() {
  [ ! "$quick$again" ] && command -v gnuplot >/dev/null || return 0
  (cd "$out" && gnuplot -e "set terminal pngcairo size 900,560 font 'sans,11'; set output '$1.png';
    set datafile separator ','; set grid; set key left top" "$here/$1.gp")
}
