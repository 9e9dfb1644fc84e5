# Properties of a simple cubic lattice of spacing 1 with E = 1, density 1 and the horizon m, by sums over the bonds of
# one particle. Nothing is read from the program. Prints one quantity a line.
# usage: awk -v m=3 [-v k=0.1] [-v nu=0.3] [-v section=6] -f lattice.awk        k: wave number in pi/spacing
# With another Poisson's ratio nu than that of bonds alone, 1/4, in plane stress 1/3, moduli are those of bonds with the
# same shear modulus plus, in c11 and c12, what the material's bulk modulus is above that of these bonds.
#     C_ijkl = (1/2) sum c G xi_i xi_j xi_k xi_l/|xi|^3
#     omega^2 = sum c G (xi.e)^2/|xi|^3 (1 - cos k.xi)      c = 12/(pi m^4)
# With `section`, of a bar of so many spacings across, without surface correction, whose section is strained uniformly:
# bar_e, its modulus over that of the lattice; bar_e_trace, the same if each family had the dilatation of the strain;
# bar_theta_0, 1, 2: dilatation of the families at the middle of a face, and deeper, over that of the strain
# G is the volume of a unit cube within the sphere of radius m: slices of exact area (rectangle and disc), integrated by
# Gauss's rule across the slices.

function min(a, b) { return a < b ? a : b }
function primitive(t, r) { # integral of sqrt(r^2 - t^2)
  return (t * sqrt(max0(r * r - t * t)) + r * r * atan2(t, sqrt(max0(r * r - t * t)))) / 2
}
function max0(a) { return a > 0 ? a : 0 }
function quadrant(x, y, r,   sign, turn) { # area of the disc within [0, x] x [0, y], odd in both
  sign = (x < 0 ? -1 : 1) * (y < 0 ? -1 : 1)
  x = min(x < 0 ? -x : x, r); y = min(y < 0 ? -y : y, r)
  if (x * x + y * y <= r * r) return sign * x * y
  turn = sqrt(r * r - y * y)
  return sign * (turn * y + primitive(x, r) - primitive(turn, r))
}
function slice(x, y, z,   r) {
  if (z * z >= m * m) return 0
  r = sqrt(m * m - z * z)
  return quadrant(x + 0.5, y + 0.5, r) - quadrant(x - 0.5, y + 0.5, r) - quadrant(x + 0.5, y - 0.5, r) + \
    quadrant(x - 0.5, y - 0.5, r)
}
function disc(x, y) { # area of the unit square about x, y inside the disc of radius m
  return quadrant(x + 0.5, y + 0.5, m) - quadrant(x - 0.5, y + 0.5, m) - quadrant(x + 0.5, y - 0.5, m) + \
    quadrant(x - 0.5, y - 0.5, m)
}
function part(x, y, z,   n, i, c, g, sum, far, near) {
  far = (x + 0.5) ^ 2 + (y + 0.5) ^ 2 + (z + 0.5) ^ 2
  if (far <= m * m) return 1
  n = 400; g = sqrt(0.6) / (2 * n); sum = 0
  for (i = 0; i < n; i++) {
    c = z - 0.5 + (i + 0.5) / n
    sum += (5 * slice(x, y, c - g) + 8 * slice(x, y, c) + 5 * slice(x, y, c + g)) / (18 * n)
  }
  return sum
}
function part_kept(i, j, l,   t, key) { # part(i, j, l), computed once for all signs and orders of i, j, l
  i = i < 0 ? -i : i; j = j < 0 ? -j : j; l = l < 0 ? -l : l
  if (i > j) { t = i; i = j; j = t }
  if (j > l) { t = j; j = l; l = t }
  if (i > j) { t = i; i = j; j = t }
  key = i " " j " " l
  if (!(key in kept)) kept[key] = part(i, j, l)
  return kept[key]
}
function bar_modulus(across, shear, k, trace,   p, q, b, y, z, at, M, M0, full, t0, t1, e, a00, a01, a11, e0, nu0) {
  for (b = 1; b <= family; b++) M0 += shear * bond_k[b]
  e0 = c11 - 2 * c12 * c12 / (c11 + c12); nu0 = c12 / (c11 + c12)
  for (y = 0; y < across; y++)
    for (z = 0; z < across; z++) {
      M = t0 = t1 = 0
      for (b = 1; b <= family; b++) {
        p = y + bond_y[b]; q = z + bond_z[b]
        if (p < 0 || p >= across || q < 0 || q >= across) continue
        at = bond_n[b]; full = shear * bond_k[b]; M += full
        t0 += full * at; t1 += full * (1 - at)
        a00 += full * at * at / 2; a01 += full * at * (1 - at) / 2; a11 += full * (1 - at) ^ 2 / 2
      }
      t0 *= 3 / M; t1 *= 3 / M
      if (y == int(across / 2)) theta[z] = (t0 - nu0 * t1) / (1 - 2 * nu0)
      if (trace) { t0 = 1; t1 = 2 }
      e = (k - M0 / 18) * M / M0
      a00 += e * t0 * t0; a01 += e * t0 * t1; a11 += e * t1 * t1
    }
  return (a00 - a01 * a01 / a11) / across ^ 2 / e0
}
BEGIN {
  pi = atan2(0, -1); c = 12 / (pi * m ^ 4); reach = int(m + 0.5)
  for (i = -reach; i <= reach; i++)
    for (j = -reach; j <= reach; j++)
      for (l = -reach; l <= reach; l++) {
        r2 = i * i + j * j + l * l
        if (r2 == 0 || r2 >= (m + 0.5) ^ 2 * (1 - 1e-12)) continue
        g = part_kept(i, j, l); r = sqrt(r2); f = c * g / (r2 * r)
        family++; volume += g
        bond_y[family] = j; bond_z[family] = l; bond_n[family] = i * i / r2; bond_k[family] = c * g * r
        c11 += f * i ^ 4 / 2; c12 += f * i * i * j * j / 2
        wave = 1 - cos(pi * k * i)
        along += f * i * i * wave; across += f * j * j * wave
        if (i > 0) cleaved += 0.5 * c * r * g * i * 5 / (6 * m)
      }
  reach = int(m + 1) # in plane stress, thickness 1: the square cells that the disc of radius m meets, c = 9/(pi m^3)
  for (i = -reach; i <= reach; i++)
    for (j = -reach; j <= reach; j++) {
      r2 = i * i + j * j
      if (r2 == 0) continue
      g = disc(i, j)
      f = 9 / (pi * m ^ 3) * g / (r2 * sqrt(r2))
      plane11 += f * i ^ 4 / 2; plane12 += f * i * i * j * j / 2
    }
  c44 = c12; plane44 = plane12
  if (nu != "" && nu != 0.25) {
    shear = 1.25 / (1 + nu); excess = 1 / (3 * (1 - 2 * nu)) - shear * (c11 + 2 * c12) / 3
    c44 *= shear; c11 = shear * c11 + excess; c12 = shear * c12 + excess
  }
  if (nu != "" && (nu < 0.333 || nu > 0.3334)) {
    shear = 4 / 3 / (1 + nu); excess = 1 / (2 * (1 - nu)) - shear * (plane11 + plane12) / 2
    plane44 *= shear; plane11 = shear * plane11 + excess; plane12 = shear * plane12 + excess
  }
  printf "family %d\nvolume %.12g\nc11 %.12g\n", family, volume / (4 * pi * m ^ 3 / 3), c11
  printf "c12 %.12g\nc44 %.12g\n", c12, c44
  printf "e100 %.12g\nnu100 %.12g\n", c11 - 2 * c12 * c12 / (c11 + c12), c12 / (c11 + c12)
  printf "plate100 %.12g\n", c11 - c12 * c12 / c11
  printf "plane_c11 %.12g\nplane_c12 %.12g\nplane_c44 %.12g\nplane_e100 %.12g\nplane_nu100 %.12g\n", plane11, plane12,
    plane44, plane11 - plane12 * plane12 / plane11, plane12 / plane11
  printf "g100 %.12g\nomega_l %.12g\nomega_t %.12g\n", cleaved, sqrt(along), sqrt(across)
  if (section) {
    shear = nu == "" ? 1 : 1.25 / (1 + nu); bulk = (c11 + 2 * c12) / 3
    printf "bar_e %.6g\n", bar_modulus(section, shear, bulk, 0)
    for (i = 0; i < 3; i++) printf "bar_theta_%d %.3g\n", i, theta[i]
    printf "bar_e_trace %.6g\n", bar_modulus(section, shear, bulk, 1)
  }
}
