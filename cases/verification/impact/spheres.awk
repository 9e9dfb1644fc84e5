# Prints a scene: two equal spheres of radius r (in spacings) that meet along the direction x, y, z, with E = 1, density
# 1 and the relative velocity v; 1.35 times Hertz's duration. nu: their Poisson's ratio, if it is not 1/4.
# usage: awk -v r=10 -v x=1 -v y=0 -v z=0 -v v=0.02 [-v nu=0.2] -f this
BEGIN {
  pi = atan2(0, -1)
  n = sqrt(x * x + y * y + z * z); x /= n; y /= n; z /= n
  ratio = nu == "" ? "" : ", poisson_ratio: " nu
  if (nu == "") nu = 0.25
  es = 1 / (2 * (1 - nu * nu)); m = 4 / 3 * pi * r ^ 3 / 2; rs = r / 2
  delta = (15 * m * v * v / (16 * es * sqrt(rs))) ^ 0.4
  a = r + 4
  print "title: Two equal spheres meet"
  printf "domain: {size: [%.10g, %.10g, %.10g]}\n", 2 * a + 2 * r * x, 2 * a + 2 * r * y, 2 * a + 2 * r * z
  print "solid:\n  spacing: 1\n  materials:\n    - {name: elastic, youngs_modulus: 1, density: 1" ratio "}\n  bodies:"
  printf "    - {name: one, shape: sphere, centre: [%g, %g, %g], radius: %g, velocity: [%.12g, %.12g, %.12g]}\n",
    a, a, a, r, v * x, v * y, v * z
  printf "    - {name: two, shape: sphere, centre: [%.12g, %.12g, %.12g], radius: %g}\n",
    a + 2 * r * x, a + 2 * r * y, a + 2 * r * z, r
  print "stages:"
  printf "  - {name: impact, steps: %d, time_step: 0.85, integrator: verlet, safety: 0.5}\n",
    1.35 * 2.9432 * delta / v / 0.85
  print "output: {series_every: 1, fields_every: 0, checkpoint_every: 0}"
}
