#!/usr/bin/env bash
# Prints, in a run folder of hole.yaml, by how much two particles beside the hole part, over what Kirsch's solution of
# an unbounded plate (1898) has at their places: `along` the tension, `across` it, or `edge`, two neighbours of the one
# beside the hole where the stress is largest.  usage: hole.sh along|across|edge
of() { awk -v key="$1:" '$1 == key { print $2; exit }' scene.resolved.yaml; }
awk -F, -v what="$1" -v r0="$(of radius)" -v nu="$(of poisson_ratio)" '
  # displacement over tension/E along the tension (x) and across it at x, y from the centre, plane stress
  function kirsch(x, y,  r, q2, t, radial, turning) {
    r = sqrt(x * x + y * y); q2 = r0 * r0 / (r * r); t = atan2(y, x)
    radial = r / 2 * (1 - nu + (1 + nu) * q2 + (1 + nu + 4 * q2 - (1 + nu) * q2 * q2) * cos(2 * t))
    turning = -r / 2 * (1 + nu + 2 * (1 - nu) * q2 + (1 + nu) * q2 * q2) * sin(2 * t)
    ux = radial * cos(t) - turning * sin(t); uy = radial * sin(t) + turning * cos(t)
  }
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
  NR > 2 { x[$3] = $at["x"]; y[$3] = $at["y"]; u[$3] = $at["displacement_x"]; v[$3] = $at["displacement_y"] }
  END {
    a = what == "along" ? 0 : what == "across" ? 2 : 4; b = a + 1
    centre_x = (x[2] + x[3]) / 2; centre_y = (y[0] + y[1]) / 2
    kirsch(y[b] - centre_y, x[b] - centre_x); exact = what == "across" ? uy : ux
    kirsch(y[a] - centre_y, x[a] - centre_x); exact -= what == "across" ? uy : ux
    printf "%.10g\n", (what == "across" ? u[b] - u[a] : v[b] - v[a]) / (1e-8 * exact)
  }' probes.csv
