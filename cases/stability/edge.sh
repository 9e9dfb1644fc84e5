#!/usr/bin/env bash
# Numbers of the maps, for the commands of their gates.yaml: runs with frana run --set, in the folder of a map's runs.
#   edge.sh edge CONDITION FROM GOOD BAD WITHIN SCENE SETTING...
#       the limit of the value that replaces @ in the settings, by bisection between GOOD and BAD times FROM: the middle
#       of the last interval, whose ends have a ratio of at most 1 + WITHIN. BAD if BAD holds too, nan if GOOD does not.
#       A run holds if it is stable and CONDITION is true. FROM is a number, or a LINE as below
#   edge.sh run UNSTABLE PRINT SCENE SETTING...     what PRINT prints, or the text UNSTABLE if the run is unstable
#   edge.sh step LINE SCENE SETTING...              the stable step that `frana check` prints after LINE
#   edge.sh plot NAME                               draws NAME.png by the map's NAME.gp, if there is gnuplot
# CONDITION and PRINT are awk code, with n lines of series.csv, its columns value[k, NAME], and max(NAME, from, to), the
# largest magnitude of a column.
set -euo pipefail
export LC_ALL=C OMP_NUM_THREADS=1
verb=$1
shift
calc() { awk "BEGIN { printf \"%.12g\\n\", $1 }"; }
of_series() { # of_series CODE
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) name[i] = $i } NR <= 2 { next }
    { n++; for (i = 1; i <= NF; i++) value[n, name[i]] = $i }
    function max(c, from, to,  k, y, m) { for (k = from; k <= to; k++) { y = value[int(k), c]; if (y < 0) y = -y
      if (y > m || y != y) m = y } return m }
    END { '"$1"' }' run/series.csv
}
# made SCENE SETTING...: returns 1 if the run is unstable, and exits if it fails otherwise.
made() {
  local code=0 words=("$FRANA_STUDY/$1.yaml" --out run --quiet) s
  for s in "${@:2}"; do words+=(--set "$s"); done
  rm -rf run
  "$FRANA" run "${words[@]}" >run.log 2>&1 || code=$?
  case $code in
    0) ;;
    3) return 1 ;;
    *) cat run.log >&2; exit 2 ;;
  esac
}
step() {
  local words=("$FRANA_STUDY/$2.yaml") s
  for s in "${@:3}"; do [[ $s == *@* ]] || words+=(--set "$s"); done
  "$FRANA" check "${words[@]}" | sed -n "s/^  $1 *\([0-9.e+-]*\)\( s.*\)\?\$/\1/p"
}
edge() {
  local condition=$1 from=$2 good bad mid within=$5 scene=$6 settings=("${@:7}")
  [[ $from =~ ^[0-9] ]] || from=$(step "$from" "${@:6}")
  good=$(calc "$3 * $from") bad=$(calc "$4 * $from")
  holds() { made "$scene" "${settings[@]//@/$1}" && [ "$(of_series "print ($condition)")" = 1 ]; }
  if ! holds "$good"; then
    echo nan
  elif holds "$bad"; then
    echo "$bad"
  else
    while [ "$(calc "(($good > $bad ? $good / $bad : $bad / $good) > 1 + $within)")" = 1 ]; do
      mid=$(calc "sqrt($good * $bad)")
      if holds "$mid"; then good=$mid; else bad=$mid; fi
    done
    calc "sqrt($good * $bad)"
  fi
}
plot() {
  command -v gnuplot >/dev/null || return 0
  cd "$FRANA_RESULTS"
  gnuplot -e "set terminal pngcairo size 900,560 font 'sans,11'; set output '$1.png'; set datafile separator ',';
    set grid; set key left top" "$FRANA_STUDY/$1.gp"
}
case $verb in
  edge) edge "$@" ;;
  step) step "$@" ;;
  plot) plot "$@" ;;
  run) if made "${@:3}"; then of_series "$2"; else echo "$1"; fi ;;
esac
