# Writes the scene of a plate that is turned on the lattice. Read before the awk file of a case, whose BEGIN calls
# turned_begin() and then prints its cracks, loads and stages.
# Variables (-v): turn     counterclockwise, degrees
#                 width, height   of the plate, whose own axes begin at its lower left corner, m
#                 size     of the square domain in whose middle the plate's middle stands, m
#                 spacing, m, title, material (the keys of its elasticity and strength), model
#                 variant  "lattice X Y": the lattice, moved by X and Y spacings; "seed N": particles moved by up to
#                          0.2 spacings at random; "centroidal N": centroidal points of seed N; "cells N": these with
#                          the volumes of their Voronoi cells; "hexagonal"
function turned_setup() { rad = turn * atan2(0, -1) / 180; c = cos(rad); s = sin(rad) }
# the place of the plate's own (x, y) in the domain, and a vector along the plate's axes, as lists
function at(x, y) {
  x -= width / 2; y -= height / 2
  return sprintf("[%.12g, %.12g]", size / 2 + c * x - s * y, size / 2 + s * x + c * y)
}
function along(x, y) { return sprintf("[%.9g, %.9g]", c * x - s * y, s * x + c * y) }
# the plate's own coordinates of a place in the domain
function own_x(x, y) { return width / 2 + c * (x - size / 2) + s * (y - size / 2) }
function own_y(x, y) { return height / 2 - s * (x - size / 2) + c * (y - size / 2) }
function turned_begin(  v, on) {
  turned_setup()
  split(variant, v, " ")
  if (v[1] == "hexagonal") on = "hexagonal points"
  else on = v[1] == "centroidal" || v[1] == "cells" ? "centroidal points" : "the lattice"
  print "title: " title ", turned by " turn " degrees on " on
  print "domain: {size: [" size ", " size "]}"
  print "solid:"
  print "  spacing: " spacing
  print "  model: " model
  print "  surface_correction: volume"
  if (v[1] == "lattice") print "  lattice_offset: [" v[2] ", " v[3] "]"
  print "  materials:"
  print "    - {name: plate, " material ", horizon_ratio: " m "}"
  print "  bodies:"
  print "    - {name: plate, shape: polygon,"
  if (v[1] == "seed") print "       arrangement: {kind: perturbed, perturbation: 0.2, seed: " v[2] "},"
  if (v[1] == "centroidal") print "       arrangement: {kind: centroidal, seed: " v[2] "},"
  if (v[1] == "cells") print "       arrangement: {kind: centroidal, seed: " v[2] ", volume: cell},"
  if (v[1] == "hexagonal") print "       arrangement: {kind: hexagonal},"
  print "       outline: [" at(0, 0) ", " at(width, 0) ", " at(width, height) ", " at(0, height) "]}"
}
