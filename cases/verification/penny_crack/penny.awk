# Prints the scene of a penny-shaped crack of radius a in a cube of half side b, under the pressure 1e-6 E.
# usage: awk -v a=6 -v b=18 -f penny.awk
# The crack is a fan of twelve quadrilaterals. The pressure acts on the particles of the two layers next to the crack,
# row by row.
BEGIN {
  pi = atan2(0, -1)
  printf "title: A penny-shaped crack under pressure\ndomain: {size: [%d, %d, %d]}\n", 2 * b, 2 * b, 2 * b
  print "solid:\n  spacing: 1\n  materials:\n    - {name: elastic, youngs_modulus: 1, density: 1, horizon_ratio: 3}"
  printf "  bodies:\n    - {shape: box, low: [0, 0, 0], high: [%d, %d, %d]}\n  cracks:\n", 2 * b, 2 * b, 2 * b
  for (i = 0; i < 24; i += 2) {
    printf "    - points: [[%d, %d, %d]", b, b, b
    for (j = i; j <= i + 2; j++) printf ", [%.9g, %.9g, %d]", b + a * cos(j * pi / 12), b + a * sin(j * pi / 12), b
    print "]"
  }
  print "  loads:"
  for (y = -a + 0.5; y < a; y++) {
    half = sqrt(a * a - y * y)
    for (s = -1; s <= 1; s += 2)
      printf "    - {low: [%.9g, %g, %d], high: [%.9g, %g, %d], force: [0, 0, %de-6]}\n", \
        b - half, b + y - 0.25, b + (s < 0 ? -1 : 0), b + half, b + y + 0.25, b + (s > 0), s
  }
  print "  contact: {enabled: false}\nstages:\n  - {name: open, steps: 1, relax: true}"
  printf "output:\n  series_every: 0\n  checkpoint_every: 0\n"
  printf "  probes: {at: [[%d.5, %d.5, %d.5], [%d.5, %d.5, %d.5]], every: 1}\n", b, b, b, b, b, b - 1
}
