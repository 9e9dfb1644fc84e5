#!/bin/sh
# Computes, in a run folder, means from t = 20 h/u_tau on from fluid_probes.csv. Both halves of the channel are
# averaged. The unit is the friction velocity from the mean flow's slope at the walls. The results are stored in
# statistics.csv, profiles.csv and stress.csv. The position of a line of probes within a cell tells what it measures:
# u (x face, y and z centre), uv and v (x and y face), w (z face).
# usage: statistics.sh time|bulk|centre|u|v|w|uv|stress
set -eu
# shellcheck disable=SC3013 # dash and bash have -nt
[ statistics.csv -nt fluid_probes.csv ] || awk -F, -v from="${FROM:-20}" '
  function near(a, b) { a -= b; return a * a < 1e-12 }
  NR <= 2 || $2 < from { next }
  {
    if (!nu) { nu = 5.6142e-3; n = 96; dy = 2 / n; dz = 0.4 * 3.14159265358979 / 48 }
    if (!first) first = $2
    last = $2
    j = int($5 / dy + 0.25) # centre: its cell; face: the number of cells below it
    if (near($5, j * dy)) { u2[j] += $7; v2[j] += $8; vv[j] += $8 * $8; uv[j] += $7 * $8; n2[j]++ }
    else if (near($6 / dz, int($6 / dz + 0.25))) { w[j] += $9; ww[j] += $9 * $9; nw[j]++ }
    else { u[j] += $7; uu[j] += $7 * $7; n1[j]++ }
  }
  END {
    for (j = 0; j < n; j++) {
      U[j] = u[j] / n1[j]; R[j] = uu[j] / n1[j] - U[j] ^ 2
      W[j] = ww[j] / nw[j] - (w[j] / nw[j]) ^ 2
    }
    for (j = 1; j < n; j++) {
      if (!n2[j]) continue
      V[j] = vv[j] / n2[j] - (v2[j] / n2[j]) ^ 2
      S[j] = -(uv[j] / n2[j] - u2[j] * v2[j] / n2[j] ^ 2)
      T[j] = S[j] + nu * (U[j] - U[j - 1]) / dy
    }
    tau = nu * (U[0] + U[n - 1]) / dy; ut = sqrt(tau)
    print "y_plus,U,u,w\n#1,u_tau,u_tau,u_tau" >"profiles.csv"
    print "y_plus,v,minus_uv,total_stress,total_stress_exact\n#1,u_tau,u_tau2,u_tau2,u_tau2" >"stress.csv"
    for (j = 0; j < n / 2; j++) {
      k = n - 1 - j
      a = sqrt((R[j] + R[k]) / 2) / ut; b = sqrt((W[j] + W[k]) / 2) / ut
      if (a > A) A = a
      if (b > B) B = b
      printf "%.6g,%.6g,%.6g,%.6g\n", (j + 0.5) * dy * ut / nu, (U[j] + U[k]) / 2 / ut, a, b >"profiles.csv"
    }
    for (j = 1; j < n / 2; j++) {
      k = n - j
      if (!n2[j]) continue
      c = sqrt((V[j] + V[k]) / 2) / ut; s = (S[j] - S[k]) / 2 / tau; t = (T[j] - T[k]) / 2 / tau
      e = t - (1 - j * dy)
      if (e < 0) e = -e
      if (c > C) C = c
      if (s > D) D = s
      if (e > E) E = e
      printf "%.6g,%.6g,%.6g,%.6g,%.6g\n", j * dy * ut / nu, c, s, t, 1 - j * dy >"stress.csv"
    }
    printf "quantity,value\ntime,%.10g\nbulk,%.10g\ncentre,%.10g\n", (last - first) * ut,
      15.68 / ut, (U[n / 2] + U[n / 2 - 1]) / 2 / ut
    printf "u,%.10g\nv,%.10g\nw,%.10g\nuv,%.10g\nstress,%.10g\n", A, C, B, D, E
  }' fluid_probes.csv >statistics.csv
sed -n "s/^$1,//p" statistics.csv
