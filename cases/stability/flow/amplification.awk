# Prints the shortest step at which one of the waves on 8 cells grows, for U = 1 in each direction and cells of size 1;
# 100 if none does up to there. The scheme is low-storage RK3 with central differences. The rates of a wave are
# i c = -i sum sin(theta) and l = 2 nu sum (1 - cos(theta)).
# usage: awk -v kind=explicit|implicit -v nu=NU -f amplification.awk
function grows(c, l,  r, x, y, fx, fy, ox, oy, nx, ny, d) { # c and l are multiplied by the step
  x = 1; y = ox = oy = 0
  for (r = 0; r < 3; r++) {
    fx = c * y; fy = -c * x; d = 1
    if (kind == "explicit") { fx -= l * x; fy -= l * y } else d = 1 + (a[r] + b[r]) * l
    nx = (x + a[r] * fx + b[r] * ox) / d; ny = (y + a[r] * fy + b[r] * oy) / d
    x = nx; y = ny; ox = fx; oy = fy
  }
  return x * x + y * y > 1 + 1e-9
}
function any(dt,  i, j, k) {
  for (i = 0; i <= 4; i++) for (j = 0; j <= i; j++) for (k = 0; k <= j; k++)
    if (i && grows(dt * (s[i] + s[j] + s[k]), dt * 2 * nu * (3 - q[i] - q[j] - q[k]))) return 1
  return 0
}
BEGIN {
  a[0] = 8 / 15; a[1] = 5 / 12; a[2] = 3 / 4; b[1] = -17 / 60; b[2] = -5 / 12
  for (i = 0; i <= 4; i++) { s[i] = sin(atan2(0, -1) * i / 4); q[i] = cos(atan2(0, -1) * i / 4) }
  dt = 1e-3; if (nu > 1) dt /= nu
  while (!any(dt) && dt < 100) dt *= 1.005
  if (dt >= 100) { print 100; exit }
  low = dt / 1.005; high = dt
  for (n = 0; n < 30; n++) { dt = (low + high) / 2; if (any(dt)) high = dt; else low = dt }
  print dt
}
