# The first circular frequency of Timoshenko's beam, clamped at one end and free at the other: density 1, section h x h,
# length l, moduli e and g, shear factor 5/6. The equations are
#     w' = phi + Q/(k G A)    phi' = M/(E I)    M' = -Q - rho I omega^2 phi    Q' = -rho A omega^2 w
# Q is positive along w. Two solutions start at the clamp with w = phi = 0. At the first frequency the determinant of
# their (M, Q) at the tip changes sign.
function slope(y, d) {
  d[1] = y[2] + y[4] / shear; d[2] = y[3] / bend; d[3] = -y[4] - inertia * o2 * y[2]; d[4] = -area * o2 * y[1]
}
function march(m0, q0,   i, k, s) { # leaves M and Q of the tip in y[3], y[4]; classical Runge-Kutta method of order 4
  y[1] = y[2] = 0; y[3] = m0; y[4] = q0
  for (i = 0; i < steps; i++) {
    slope(y, k1); for (k = 1; k <= 4; k++) z[k] = y[k] + s2 * k1[k]
    slope(z, k2); for (k = 1; k <= 4; k++) z[k] = y[k] + s2 * k2[k]
    slope(z, k3); for (k = 1; k <= 4; k++) z[k] = y[k] + 2 * s2 * k3[k]
    slope(z, k4); for (k = 1; k <= 4; k++) y[k] += s2 / 3 * (k1[k] + 2 * k2[k] + 2 * k3[k] + k4[k])
  }
}
function determinant(omega,   m, q) {
  o2 = omega * omega
  march(1, 0); m = y[3]; q = y[4]
  march(0, 1)
  return m * y[4] - q * y[3]
}
BEGIN {
  area = h * h; inertia = h ^ 4 / 12; bend = e * inertia; shear = 5 / 6 * g * area; steps = 200; s2 = l / steps / 2
  euler = 3.5160152685 / (l * l) * sqrt(bend / area)
  low = 0; high = euler; sign = determinant(0) # 1 at rest
  for (step = 1; step <= 20; step++) {
    high = euler * step / 20 * 1.2
    if (determinant(high) * sign < 0) break
    low = high
  }
  for (k = 0; k < 50; k++) {
    middle = (low + high) / 2
    if (determinant(middle) * sign < 0) high = middle
    else low = middle
  }
  printf "%.10g\n", (low + high) / 2
}
