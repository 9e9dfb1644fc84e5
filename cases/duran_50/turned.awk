# The scene of a plate with a notch to its middle that is pulled until it forks (cases/turned.sh). Oblique layers cannot
# be made unbreakable, so the traction is spread over a horizon. Variables besides those of cases/turned.awk: p (Pa),
# steps
BEGIN {
  turned_begin()
  print "  contact: {radius: 0.6}"
  print "  cracks:"
  print "    - {name: notch, points: [" at(-0.002, 0.02) ", " at(0.05, 0.02) "]}"
  print "  loads:"
  print "    - {edge: {from: " at(0, 0.04) ", to: " at(0.1, 0.04) "}, traction: " along(0, p) ", depth: horizon}"
  print "    - {edge: {from: " at(0, 0) ", to: " at(0.1, 0) "}, traction: " along(0, -p) ", depth: horizon}"
  print "stages:"
  print "  - {name: pull, steps: " steps ", time_step: 5.0e-8, integrator: verlet}"
  print "output:"
  print "  {series_every: 100, fields_every: " steps ", checkpoint_every: 0, log_every: 500, stress: false,"
  print "   crack: {damage: 0.35, window: 2.0e-6, every: 2, direction: " along(1, 0) "}}"
}
