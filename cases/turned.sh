#!/usr/bin/env bash
# shellcheck disable=SC2016 # awk in single quotes
# Plates turned on the lattice by 0, 15, 30 and 45 degrees, with three horizons, on the lattice in several places and on
# perturbed particles of several seeds. Writes results/turned.csv of the case (each run, of kalthoff each crack),
# turned_spread.csv and turned.png. With --points instead on centroidal points of five seeds, which are not turned,
# because they have no directions, and on hexagonal ones, which repeat themselves after 60 degrees: arrangement.csv and
# arrangement_spread.csv.
# usage: cases/turned.sh duran_50|soda_lime|kalthoff [--points] [RUNS]     (runs/CASE_turned)
#        cases/turned.sh duran_50|soda_lime|kalthoff [--points] --summary  runs nothing: spread and picture from the
#                                                                          first table
# FRANA is the program (build/frana). Finished runs are kept.
set -euo pipefail
cd "$(dirname "$0")/.."
. cases/common.sh
case=$1 table=turned out=cases/$1/results frana=${FRANA:-build/frana}
[ "${2-}" != --points ] || { table=arrangement && shift; }
runs=${2:-runs/${case}_turned}
mkdir -p "$out"

# points VARIANT: the two fields of the table that name the points
points() {
  case $1 in
    seed*) echo "perturbed,$1" ;;
    centroidal*) echo "centroidal,seed ${1#centroidal }" ;;
    cells*) echo "centroidal by cell,seed ${1#cells }" ;;
    hexagonal) echo "hexagonal,centred" ;;
    *) echo "lattice,moved by ${1#lattice }" ;;
  esac
}
# turned_go NAME SCENE ANGLE RATIO VARIANT VARIABLE=VALUE...: runs the plate that cases/turned.awk and the awk file
# SCENE write, unless that is done already with this very scene
turned_go() {
  local run=$runs/$1 scene=$2 variables=(-v turn="$3" -v m="$4" -v variant="$5") value
  for value in "${@:6}"; do variables+=(-v "$value"); done
  awk "${variables[@]}" -f cases/turned.awk -f "$scene" >"$run.yaml"
  if ! is_done "$run" || ! cmp -s "$run.yaml" "$run.done.yaml"; then
    rm -rf "${run:?}"
    nice "$frana" run "$run.yaml" --out "$run" >"$run.log" 2>&1 || { cat "$run.log" >&2; return 1; }
    cp "$run.yaml" "$run.done.yaml"
  fi
}

# fork_numbers ANGLE FILE: from crack-arms.csv the time (us) at which the arm from the notch ends, where (mm along the
# plate), the angles (degrees, to the plate's axis) at their ends of the arms that begin there, the outermost to the
# left and to the right, the angle between them and the difference of both sides, the number of arms, and the top speed
# of those whose speed the grid resolves (m/s)
fork_numbers() {
  awk -F, -v a="$1" '
    NR == 1 { next }
    { arms++; if ($NF == "\"resolved\"" && $16 > top) top = $16 }
    $2 == 0 && $3 == 0 && $8 > long { long = $8; stem = $1; t = $14; x = $6 - 0.06; y = $7 - 0.06 }
    { parent[$1] = $2; turn[$1] = $11 - a; reach[$1] = $8 }
    END {
      pi = atan2(0, -1); left = right = "nan"
      for (k in parent) {
        if (parent[k] != stem) continue
        if (left == "nan" || turn[k] > left) left = turn[k]
        if (right == "nan" || turn[k] < right) right = turn[k]
      }
      top = top ? sprintf("%.0f", top) : "nan"
      if (left == "nan") { printf "nan,nan,nan,nan,nan,nan,%d,%s\n", arms, top; exit }
      place = 50 + 1e3 * (cos(a * pi / 180) * x + sin(a * pi / 180) * y)
      uneven = left + right; if (uneven < 0) uneven = -uneven
      printf "%.1f,%.1f,%.1f,%.1f,%.1f,%.1f,%d,%s\n", 1e6 * t, place, left, -right, left - right, uneven, arms, top
    }' "$2"
}
# fork ANGLE RATIO VARIANT: the row of a plate of 100 x 40 mm with a notch to the middle that forks
fork() {
  local name=m$2_${3// /_}_$1
  turned_go "$name" cases/duran_50/turned.awk "$@" width=0.1 height=0.04 size=0.12 spacing=1.0e-3 model=plane_stress \
    title="$title" material="$material" p="$traction" steps="$steps"
  [ "$runs/$name/post/crack-arms.csv" -nt "$runs/$name/run.json" ] ||
    nice "$frana" post "$runs/$name" >>"$runs/$name.log" 2>&1
  echo "$2,$(points "$3" | cut -d , -f 1),$1,$(points "$3" | cut -d , -f 2),$(
    fork_numbers "$1" "$runs/$name/post/crack-arms.csv")"
}
one=fork between="between (deg)" label="angle between the arms, degrees"
header="m,particles,turned by (deg),variant,arms part (us),arms part (mm),left (deg),right (deg),between (deg),\
difference of both sides (deg),arms,top speed (m/s)"
variants=("lattice 0 0" "seed 1" "seed 2" "seed 3" "seed 4" "seed 5")
arranged=("centroidal 1" "centroidal 2" "centroidal 3" "centroidal 4" "centroidal 5" hexagonal)
case $case in
  duran_50)
    title="Duran 50 glass" traction=12.0e6 steps=920
    material="youngs_modulus: 65.0e9, density: 2235, fracture_energy: 204"
    variants=("lattice 0 0" "lattice 0.25 0" "lattice 0 0.25" "lattice 0.25 0.25" "${variants[@]:1}")
    ;;
  soda_lime)
    title="Soda-lime glass" traction=13.442e6 steps=1000
    material="youngs_modulus: 72.0e9, density: 2440, fracture_energy: 135"
    ;;
  kalthoff) . cases/kalthoff/turned.sh ;;
esac
[ $table = turned ] || variants=("${arranged[@]}")

if [ "$runs" != --summary ]; then
  mkdir -p "$runs"
  echo "$header" >"$out/$table.part"
  for variant in "${variants[@]}"; do
    case $variant in centroidal* | cells*) angles=0 ;; hexagonal) angles="0 15 30" ;; *) angles="0 15 30 45" ;; esac
    for m in 3 4 5; do for angle in $angles; do $one "$angle" "$m" "$variant"; done; done
  done >>"$out/$table.part"
  mv "$out/$table.part" "$out/$table.csv"
fi
# The spread: of each quantity (columns after "variant") number of values, mean, standard deviation, least and largest:
# for each angle; over all runs ("all"); of the angles' means ("means": what the direction does); and the root mean
# square of the deviations within the angles ("within": what the seed or the lattice's place does). Rows of the same
# fields before "turned by" belong together; nan is left out.
awk -F, '
  NR == 1 {
    for (i = 1; i <= NF; i++) { name[i] = $i; if ($i ~ /^turned by/) t = i; if ($i == "variant") first = i + 1 }
    last = NF; next }
  { g = $1; for (i = 2; i < t; i++) g = g "," $i
    if (!(g in known)) { known[g]; group[++groups] = g }
    if (!(g "," $t in known)) { known[g "," $t]; angle[g, ++angles[g]] = $t }
    for (i = first; i <= last; i++) { add(g SUBSEP $t SUBSEP i, $i); add(g SUBSEP "all" SUBSEP i, $i) } }
  function add(k, v) {
    rows[k]++
    if (v == "nan") return
    if (!n[k] || v < least[k]) least[k] = v + 0
    if (!n[k] || v > most[k]) most[k] = v + 0
    n[k]++; sum[k] += v; squares[k] += v * v
  }
  function mean(k) { return n[k] ? sum[k] / n[k] : 0 }
  function deviation(k,  d) {
    if (n[k] < 2) return 0
    d = (squares[k] - n[k] * mean(k) ^ 2) / (n[k] - 1)
    return d > 0 ? sqrt(d) : 0
  }
  function put(g, a, i,  k) {
    k = g SUBSEP a SUBSEP i
    if (n[k]) printf "%s,%s,%s,%d,%d,%.4g,%.3g,%.4g,%.4g\n", g, a, name[i], rows[k], n[k], mean(k), deviation(k),
      least[k], most[k]
    else printf "%s,%s,%s,%d,0,nan,nan,nan,nan\n", g, a, name[i], rows[k]
  }
  END {
    for (i = 1; i <= t; i++) printf "%s,", name[i]
    print "quantity,runs,with a value,mean,deviation,least,largest"
    for (q = 1; q <= groups; q++) for (i = first; i <= last; i++) {
      g = group[q]; inside = free = 0
      for (j = 1; j <= angles[g]; j++) {
        a = angle[g, j]; k = g SUBSEP a SUBSEP i
        put(g, a, i)
        if (n[k]) add(g SUBSEP "means" SUBSEP i, mean(k))
        if (n[k] > 1) { inside += (n[k] - 1) * deviation(k) ^ 2; free += n[k] - 1 }
      }
      put(g, "means", i); put(g, "all", i)
      printf "%s,within,%s,%d,%d,nan,%.3g,nan,nan\n", g, name[i], rows[g SUBSEP "all" SUBSEP i], free,
        free ? sqrt(inside / free) : 0
    } }' "$out/$table.csv" >"$out/${table}_spread.csv"
[ $table = arrangement ] ||
  (cd "$out" && gnuplot -e "quantity = '$between'; label = '$label'; steel = '${steel-}'" ../../turned.gp)
