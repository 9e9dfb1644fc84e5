#!/usr/bin/env bash
# The plate of 4,000 particles turned on the lattice, with three horizons, on the lattice and on perturbed particles:
# what of its fork is the lattice's. Writes results/turned.csv (each run) and results/turned_spread.csv.
# usage: cases/soda_lime/turned.sh [RUNS]      (runs/soda_lime_turned)
# FRANA is the program (build/frana). Finished runs are kept.
set -euo pipefail
cd "$(dirname "$0")/../.."
runs=${1:-runs/soda_lime_turned} out=cases/soda_lime/results frana=${FRANA:-build/frana}
mkdir -p "$runs" "$out"

# scene DEGREES M SEED: the plate turned about the middle of a larger domain; seed 0: on the lattice. Oblique layers
# cannot be made unbreakable, so the traction is spread over a horizon.
scene() {
  awk -v a="$1" -v m="$2" -v seed="$3" '
    function at(x, y) {
      x -= 0.05; y -= 0.02
      return sprintf("[%.12g, %.12g]", 0.06 + c * x - s * y, 0.06 + s * x + c * y)
    }
    function pull(t) { return sprintf("[%.9g, %.9g]", -s * t, c * t) }
    BEGIN {
      turn = a * atan2(0, -1) / 180; c = cos(turn); s = sin(turn)
      if (seed) moved = ", arrangement: {kind: perturbed, perturbation: 0.2, seed: " seed "}"
      print "title: Soda-lime glass, turned by " a " degrees on the lattice"
      print "domain: {size: [0.12, 0.12]}"
      print "solid:"
      print "  spacing: 1.0e-3"
      print "  model: plane_stress"
      print "  materials:"
      print "    - {name: glass, youngs_modulus: 72.0e9, density: 2440, fracture_energy: 135, horizon_ratio: " m "}"
      print "  bodies:"
      corners = at(0, 0) ", " at(0.1, 0) ", " at(0.1, 0.04) ", " at(0, 0.04)
      print "    - {name: plate, shape: polygon, outline: [" corners "]" moved "}"
      print "  contact: {radius: 0.6}"
      print "  cracks:"
      print "    - {name: notch, points: [" at(-0.002, 0.02) ", " at(0.05, 0.02) "]}"
      print "  loads:"
      print "    - {edge: {from: " at(0, 0.04) ", to: " at(0.1, 0.04) "}, traction: " pull(13.442e6) ", depth: horizon}"
      print "    - {edge: {from: " at(0, 0) ", to: " at(0.1, 0) "}, traction: " pull(-13.442e6) ", depth: horizon}"
      print "stages:"
      print "  - {name: pull, steps: 1000, time_step: 5.0e-8, integrator: verlet}"
      print "output:"
      print "  {series_every: 100, fields_every: 1000, checkpoint_every: 0, log_every: 500, stress: false,"
      print "   crack: {damage: 0.35, window: 2.0e-6, every: 2, direction: [" c ", " s "]}}"
    }'
}

# numbers DEGREES FILE: of crack-arms.csv: the time (us) at which the arm from the notch ends, where (mm along the
# plate), the angles (degrees, to the plate's axis) of the arms that begin there at their ends, to the left and to the
# right; the number of arms; the top speed (m/s)
numbers() {
  awk -F, -v a="$1" '
    NR == 1 { next }
    { arms++; if ($16 > top) top = $16 }
    $2 == 0 && $3 == 0 && $8 > long { long = $8; stem = $1; t = $14; x = $6 - 0.06; y = $7 - 0.06 }
    { parent[$1] = $2; turn[$1] = $11 - a; reach[$1] = $8 }
    END {
      pi = atan2(0, -1); left = right = "nan"
      for (k in parent) {
        if (parent[k] != stem) continue
        if (left == "nan" || turn[k] > left) left = turn[k]
        if (right == "nan" || turn[k] < right) right = turn[k]
      }
      if (left != "nan") place = 50 + 1e3 * (cos(a * pi / 180) * x + sin(a * pi / 180) * y)
      if (left == "nan") printf "nan,nan,nan,nan,%d,%.0f\n", arms, top
      else printf "%.1f,%.1f,%.1f,%.1f,%d,%.0f\n", 1e6 * t, place, left, -right, arms, top }' "$2"
}

table=$out/turned.csv
echo "m,turned by (deg),seed,arms part (us),arms part (mm),left (deg),right (deg),arms,top speed (m/s)" >"$table"
for m in 3 4 5; do
  for seed in 0 1 2 3 4 5; do
    for angle in 0 15 30 45; do
      name=m${m}_seed${seed}_$angle
      scene $angle $m $seed >"$runs/$name.yaml"
      [ -s "$runs/$name/post/crack-arms.csv" ] || {
        rm -rf "${runs:?}/$name"
        "$frana" run "$runs/$name.yaml" --out "$runs/$name" >"$runs/$name.log" 2>&1
        "$frana" post "$runs/$name" >>"$runs/$name.log" 2>&1
      }
      echo "$m,$angle,$seed,$(numbers $angle "$runs/$name/post/crack-arms.csv")" >>"$table"
    done
  done
done
# mean and standard deviation: over the angles on the lattice, and over angles and seeds
awk -F, '
  NR == 1 { next }
  $4 != "nan" { k = $1 "," ($3 == 0 ? "lattice" : "perturbed"); n[k]++
    split($4 "," $5 "," $6 "," $7, v, ","); v[5] = v[3] + v[4]; v[6] = v[3] - v[4]; if (v[6] < 0) v[6] = -v[6]
    for (i = 1; i <= 6; i++) { s[k, i] += v[i]; q[k, i] += v[i] ^ 2 } }
  { all[$1 "," ($3 == 0 ? "lattice" : "perturbed")]++ }
  END {
    print "m,particles,runs,with a fork,arms part (us),deviation,arms part (mm),deviation,left (deg),deviation," \
      "right (deg),deviation,between (deg),deviation,left less right (deg; magnitude),deviation"
    for (m = 3; m <= 5; m++) for (p = 0; p < 2; p++) {
      k = m "," (p ? "perturbed" : "lattice"); line = k "," all[k] "," n[k]
      for (i = 1; i <= 6; i++) { e = s[k, i] / n[k]; d = (q[k, i] - n[k] * e * e) / (n[k] > 1 ? n[k] - 1 : 1)
        line = line sprintf(",%.1f,%.1f", e, sqrt(d > 0 ? d : 0)) }
      print line } }' "$table" >"$out/turned_spread.csv"
cat "$table" "$out/turned_spread.csv"
