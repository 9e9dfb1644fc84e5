#!/usr/bin/env bash
# Prints, in a run folder, the tip's deflection over that of Timoshenko's beam, or the bending stiffness E I over that
# of the material. The stiffness comes from the third derivative of the axis's deflection. The beam is clamped at the
# face of the last held layer, or at the layer itself if all is symmetric about it. It is loaded at its last layer.
# usage: bending.sh deflection|stiffness [lattice | plane | plane_lattice]
# Timoshenko's beam has the moduli of the material, 1 and 1/(2 (1 + nu)), or with `lattice` those of the lattice;
# `plane` and `plane_lattice`: the same in plane stress.
set -euo pipefail
read -r nu m < <(awk '$1 == "poisson_ratio:" { nu = $2 } $1 == "horizon_ratio:" { m = $2 } END { print nu, m }' \
  scene.resolved.yaml)
e=1 g=$(awk -v nu="$nu" 'BEGIN { printf "%.12g", 1 / (2 * (1 + nu)) }') along=displacement_z
moduli() { # of the lattice: E along [100] and the shear modulus
  read -r e g < <(awk -v m="$m" -v nu="$nu" -f "$(dirname "$0")/../lattice.awk" |
    awk -v e="$1" -v g="$2" '{ v[$1] = $2 } END { print v[e], v[g] }')
}
case "${2:-}" in
  lattice) moduli e100 c44 ;;
  plane) along=displacement_y ;;
  plane_lattice) moduli plane_e100 plane_c44; along=displacement_y ;;
esac
read -r _ _ clamp height _ < <(awk -F'[][,]' '
  /^  constraints:/ { in_held = 1 }
  in_held && /low:/ { low = $2 }
  in_held && /high:/ { high = $2; in_held = 0 }
  /^  size:/ { height = $3 }
  END { sym = low > 0; print low, high, sym ? (low + high) / 2 : high, height, sym }' scene.resolved.yaml)
awk -F, -v along="$along" -v what="$1" -v e="$e" -v g="$g" -v clamp="$clamp" -v h="$height" '
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 && $1 == 1 { n = $3 + 0; x[n] = $at["x"] - clamp; w[n] = $at[along] * 1e6 }
  END {
    length_ = x[n]; p = 1e-2 * h * h
    if (what == "deflection") {
      print w[n] / (p / (e * h) * (4 * (length_ / h) ^ 3 + e / g * 1.2 * (length_ / h)))
      exit
    }
    for (i = 0; i < n; i++) { # w = sum a_k s^k, s = x/L, by least squares, without the tip, which is near its load
      s = x[i] / length_
      for (j = 0; j < 4; j++) {
        for (k = 0; k < 4; k++) m[j, k] += s ^ (j + k)
        b[j] += s ^ j * w[i]
      }
    }
    for (j = 0; j < 4; j++)
      for (k = j + 1; k < 4; k++) {
        f = m[k, j] / m[j, j]
        for (l = j; l < 4; l++) m[k, l] -= f * m[j, l]
        b[k] -= f * b[j]
      }
    print -p * length_ ^ 3 / (6 * b[3] / m[3, 3]) / (h ^ 4 / 12)
  }' probes.csv
