# What a turned plate of Kalthoff and Winkler has besides cases/turned.awk, with a constraint for each driven particle.
# Variables besides those there: notch (half the distance of the notches, m), every (steps between two readings of the
# crack), steps, dt
BEGIN {
  turned_begin()
  print "  contact: {enabled: false}"
  print "  cracks:"
  for (side = -1; side <= 1; side += 2)
    print "    - {name: " (side < 0 ? "lower" : "upper") ", points: [" at(-0.002, 0.1 + side * notch) ", " \
      at(0.05, 0.1 + side * notch) "]}"
  print "  constraints:"
  split(variant, v, " ")
  if (v[1] == "lattice" || v[1] == "seed") boxes(); else layer()
  print "stages:"
  print "  - {name: impact, steps: 1300, time_step: 7.0e-8, integrator: verlet, substeps: 1}"
  print "output:"
  print "  {series_every: 130, fields_every: 1300, checkpoint_every: 0, log_every: 650, stress: false,"
  print "   reactions: false, fragments: false,"
  print "   crack: {damage: 0.35, window: 1.82e-6, every: 13, direction: " along(1, 0) "}}"
}
# The driven layer, a spacing deep, of points without rows: one region, turned with the plate
function layer(  x, y, p) {
  split(substr(at(spacing / 2, 0.1), 2), p, "[],]")
  x = 0.499999 * spacing; y = notch
  printf "    - {low: [%.12g, %.12g], high: [%.12g, %.12g], rotation: {angle: %s}, directions: xy, velocity: %s}\n",
    p[1] - x, p[2] - y, p[1] + x, p[2] + y, turn, along(16.5, 0)
}
# The same on the lattice: a box about each of the layer's lattice points holds that particle, moved or not, and no
# other one.
function boxes(  dx, dy, i, j, x, y, inside, across) {
  dx = v[1] == "lattice" ? v[2] : 0; dy = v[1] == "lattice" ? v[3] : 0
  for (j = 0; j < size / spacing; j++)
    for (i = 0; i < size / spacing; i++) {
      x = (i + 0.5 + dx) * spacing; y = (j + 0.5 + dy) * spacing
      inside = own_x(x, y); across = own_y(x, y) - 0.1
      if (inside < 0 || inside > 0.999999 * spacing || across < -notch || across > notch) continue
      printf "    - {low: [%.9g, %.9g], high: [%.9g, %.9g], directions: xy, velocity: %s}\n", x - spacing / 4,
        y - spacing / 4, x + spacing / 4, y + spacing / 4, along(16.5, 0)
    }
}
