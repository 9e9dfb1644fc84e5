# shellcheck shell=bash
# shellcheck disable=SC2016,SC2034,SC2154 # awk in single quotes; variables of and for whoever sources this
# What the studies of plates turned on the lattice share, sourced by bash: scenes, runs, numbers of forks, spread.
# A study calls turned_study and turned_spread. It sets $runs, which may be --summary (nothing runs), $out, and $table:
# turned, or arrangement for points without a lattice.
here=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source=cases/common.sh
. "$here/common.sh"
frana=${FRANA:-build/frana} again=''
if [ "$runs" = --summary ]; then again=yes; else mkdir -p "$runs"; fi
mkdir -p "$out"

# turned_study HEADER ANGLES RATIOS VARIANT...: writes results/$table.csv. For each variant of the points (turned.awk),
# horizon ratio and angle it writes the rows that `one ANGLE RATIO VARIANT` prints after "particles,variant,...".
# Centroidal points are not turned, because they have no directions; hexagonal ones repeat themselves after 60 degrees.
turned_study() {
  local header=$1 angles=$2 ratios=$3 m variant angle at
  shift 3
  [ ! "$again" ] || return 0
  echo "$header" >"$out/$table.part"
  for variant in "$@"; do
    case $variant in centroidal* | cells*) at=0 ;; hexagonal) at="0 15 30" ;; *) at=$angles ;; esac
    for m in $ratios; do for angle in $at; do one "$angle" "$m" "$variant"; done; done
  done >>"$out/$table.part"
  mv "$out/$table.part" "$out/$table.csv"
}
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
# what --points studies, in place of the lattice
arranged=("centroidal 1" "centroidal 2" "centroidal 3" "centroidal 4" "centroidal 5" hexagonal)

# turned_go NAME: runs the scene $runs/NAME.yaml, unless that is done already with this very scene
turned_go() {
  if ! is_done "$runs/$1" || ! cmp -s "$runs/$1.yaml" "$runs/$1.done.yaml"; then
    rm -rf "${runs:?}/$1"
    nice "$frana" run "$runs/$1.yaml" --out "$runs/$1" >"$runs/$1.log" 2>&1 || { cat "$runs/$1.log" >&2; return 1; }
    cp "$runs/$1.yaml" "$runs/$1.done.yaml"
  fi
}

# turned_spread: writes results/${table}_spread.csv: of each quantity in results/$table.csv (columns after "variant")
# number of values, mean, standard deviation, least and largest: for each angle; over all runs ("all"); of the angles'
# means ("means": what the direction does); and the root mean square of the deviations within the angles ("within": what
# the seed or the lattice's place does). Rows of the same fields before "turned by" belong together; nan is left out.
turned_spread() {
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
}

# turned_picture QUANTITY LABEL [STEEL]: draws results/turned.png
turned_picture() {
  (cd "$out" && gnuplot -e "quantity = '$1'; label = '$2'; steel = '${3-}'" ../../turned.gp)
}

# --- plates of 100 x 40 mm with a notch to the middle that fork; $title, $material, $traction (Pa), $steps: the case's

fork_header="m,particles,turned by (deg),variant,arms part (us),arms part (mm),left (deg),right (deg),between (deg),\
difference of both sides (deg),arms,top speed (m/s)"
# fork_scene ANGLE RATIO VARIANT: oblique layers cannot be made unbreakable, so the traction is spread over a horizon
fork_scene() {
  awk -v turn="$1" -v m="$2" -v variant="$3" -v width=0.1 -v height=0.04 -v size=0.12 -v spacing=1.0e-3 \
    -v model=plane_stress -v title="$title" -v material="$material" -v p="$traction" \
    -v steps="$steps" -f "$here/turned.awk" -f <(cat <<'END2'
    BEGIN {
      turned_begin()
      print "  contact: {radius: 0.6}"
      print "  cracks:"
      print "    - {name: notch, points: [" at(-0.002, 0.02) ", " at(0.05, 0.02) "]}"
      print "  loads:"
      print "    - {edge: {from: " at(0, 0.04) ", to: " at(0.1, 0.04) "}, traction: " along(0, p) ", depth: horizon}"
      print "    - {edge: {from: " at(0, 0) ", to: " at(0.1, 0) "}, traction: " along(0, -p) ", depth: horizon}"
      print "stages:"
      print "  - {name: pull, steps: " steps ", time_step: 5.0e-8, integrator: verlet}"
      print "output:"
      print "  {series_every: 100, fields_every: " steps ", checkpoint_every: 0, log_every: 500, stress: false,"
      print "   crack: {damage: 0.35, window: 2.0e-6, every: 2, direction: " along(1, 0) "}}"
    }
END2
    )
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
# fork_one ANGLE RATIO VARIANT: a run's row
fork_one() {
  local name=m$2_${3// /_}_$1
  fork_scene "$@" >"$runs/$name.yaml"
  turned_go "$name"
  [ "$runs/$name/post/crack-arms.csv" -nt "$runs/$name/run.json" ] ||
    nice "$frana" post "$runs/$name" >>"$runs/$name.log" 2>&1
  echo "$2,$(points "$3" | cut -d , -f 1),$1,$(points "$3" | cut -d , -f 2),$(
    fork_numbers "$1" "$runs/$name/post/crack-arms.csv")"
}
# fork_study VARIANT...: all of it
fork_study() {
  one() { fork_one "$@"; }
  turned_study "$fork_header" "0 15 30 45" "3 4 5" "$@"
  turned_spread
  [ "$table" = arrangement ] || turned_picture "between (deg)" "angle between the arms, degrees"
}
