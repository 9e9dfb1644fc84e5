# shellcheck shell=bash
# shellcheck disable=SC2034,SC2154 # variables for and of cases/turned.sh, which sources this
# Both steels' plates, on the lattice in three places and with four seeds; the first steel's also with half the spacing,
# on the lattice in one place and with one seed. With --points, on 2 mm, also with the volumes of their cells.
# tips FILE ANGLE SIDE SPACING NOTCH: where the tip of the crack from the upper (SIDE is 1) or lower (-1) notch is every
# 0.91 us, in the plate's own axes, the lower crack mirrored to the upper side: the damaged particle farthest along
# (1, 1), of those that are connected with the notch across gaps of up to two particles; from crack_particles.csv
tips() {
  awk -F, -v turn="$2" -v side="$3" -v spacing="$4" -v width=0.1 -v height=0.2 -v size=0.24 -f cases/turned.awk \
    -f <(cat <<'END2'
    BEGIN { turned_setup(); print "step,t,x,y"; print "1,s,m,m" }
    NR > 2 { y = 0.1 + side * (own_y($3, $4) - 0.1); if (y < 0.1) next
      n++; t[n] = $2; px[n] = own_x($3, $4); py[n] = y }
    function join(now,  i, more) { # adds the particles that are damaged by now and connected
      do {
        more = 0
        for (i = 1; i <= n; i++) {
          if (i in is || t[i] > now) continue
          if (t[i] == t[1] || near(i)) { is[i]; more = 1 }
        }
      } while (more)
    }
    function near(i,  k) {
      for (k in is) if ((px[i] - px[k]) ^ 2 + (py[i] - py[k]) ^ 2 < (3.1 * spacing) ^ 2) return 1
      return 0
    }
    END {
      for (step = 0; step <= 1300; step += 13) {
        join(step * 7.0e-8 + 1e-9)
        far = -1; x = y = equal = 0
        for (i in is) {
          d = px[i] + py[i]
          if (d > far + 1e-6 * spacing) { far = d; x = y = equal = 0 }
          if (d > far - 1e-6 * spacing) { x += px[i]; y += py[i]; equal++ }
        }
        if (equal) printf "%d,%.6g,%.9g,%.9g\n", step, step * 7.0e-8, x / equal, y / equal
      }
    }
END2
    ) "$1"
}
# crack_row STEEL SPACING RATIO ANGLE VARIANT NAME SIDE: the row of one crack. The lower crack of a plate turned by an
# angle is the mirror image of the upper one of a plate turned by the opposite angle, or by 90
# degrees less the angle (on hexagonal points 60).
crack_row() {
  local angle=$4 repeats=90 p
  [ "$5" != hexagonal ] || repeats=60
  [ "$7" = 1 ] || angle=$(((repeats - $4) % repeats))
  tips "$runs/$6/crack_particles.csv" "$4" "$7" "$2" >"$runs/$6/tips_$7.csv"
  read -r -a p <<<"$(awk -F, -v y0="$(calc "0.1 + $(half "$2")")" -f cases/kalthoff/path.awk \
    "$runs/$6/tips_$7.csv" | tr -d ,)"
  echo "$1,$(calc "1e3 * $2"),$3,$(points "$5" | cut -d , -f 1),$angle,$(points "$5" | cut -d , -f 2),${p[0]},${p[1]},$(
    scaled 1e6 "${p[2]}"),${p[3]},${p[4]}"
}
# half SPACING: half the distance of the notches, m. On 2 mm the real 50 mm would put them on rows of particles.
half() { [ "$1" = 0.002 ] && echo 0.024 || echo 0.025; }
# plate STEEL SPACING ANGLE RATIO VARIANT: runs a plate, and prints the rows of its two cracks. On the lattice in its
# middle place plates turned by 0 and 45 degrees are symmetric, and one crack stands for both.
plate() {
  local name=$1_$2_m$4_${5// /_}_$3
  turned_go "$name" cases/kalthoff/turned.awk "${@:3}" width=0.1 height=0.2 size=0.24 spacing="$2" \
    model=plane_strain title="Kalthoff and Winkler's plate" material="${material[$1]}" notch="$(half "$2")"
  crack_row "$1" "$2" "$4" "$3" "$5" "$name" 1
  case "$5, $3" in
    "lattice 0 0, 0" | "lattice 0 0, 45") ;;
    *) crack_row "$1" "$2" "$4" "$3" "$5" "$name" -1 ;;
  esac
}
declare -A material=(
  [x2nicomo]="youngs_modulus: 191.0e9, density: 8000, fracture_energy: 38590"
  [18ni1900]="youngs_modulus: 190.0e9, density: 8000, fracture_energy: 22170"
)
both() { # both steels
  plate x2nicomo 0.002 "$@"
  plate 18ni1900 0.002 "$@"
  case $3 in "lattice 0 0" | "seed 1") plate x2nicomo 0.001 "$@" ;; esac
}
one=both between="angle by least squares (deg)" label="angle of the crack, degrees" steel=x2nicomo
header="steel,spacing (mm),m,particles,turned by (deg),variant,angle to the end (deg),\
angle by least squares (deg),left the notch (us),top speed over 1.82 us (m/s),top speed over 9.1 us (m/s)"
variants=("lattice 0 0" "seed 1" "lattice 0.25 0.25" "seed 2" "lattice 0.25 0" "seed 3" "seed 4")
arranged+=("cells 1" "cells 2" "cells 3")
