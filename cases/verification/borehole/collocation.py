#!/usr/bin/env python3
"""K_I of a round hole with two radial cracks in an unbounded plate, by collocation of stress functions.

usage: collocation.py TERMS A_OVER_R... >factors.csv      (needs numpy)
The hole has the radius 1, the cracks lie along x from it to c = 1 + a. The stress functions
    Z = sum A_n z^(-2n) z/sqrt(z^2 - c^2),    Y = sum B_n z^(-2n)
leave the cracks' faces free. Least squares over points of the hole give the coefficients; K_I = sqrt(pi c) sum A_n
c^(-2n). Prints K_I over sqrt(pi a) of the stress 1 at infinity across the cracks, of the stress 1 along them, and of
both, which is that of the pressure 1 in hole and cracks; and the largest error of a traction on the hole.
"""
import sys

import numpy as np


def stress(z, c, terms):
    """Stress xx, yy, xy of all Z_n, then of all Y_n."""
    y, root = z.imag, np.sqrt(z - c) * np.sqrt(z + c)
    for p in 2.0 * np.arange(terms):
        s, ds = z ** (1 - p) / root, (1 - p) * z**-p / root - z ** (2 - p) / root**3
        yield s.real - y * ds.imag, s.real + y * ds.imag, -y * ds.real
    for p in 2.0 * np.arange(terms):
        s, ds = z**-p, -p * z ** (-p - 1)
        yield 2 * s.real - y * ds.imag, y * ds.imag, -y * ds.real - s.imag


def solve(a, terms, across, along):
    """K_I/sqrt(pi a), largest error of a traction."""
    c = 1 + a
    points = (np.arange(6 * terms) + 0.5) / (6 * terms)
    z = np.exp(0.5j * np.pi * (1 - np.cos(0.5 * np.pi * points)))  # a quarter of the hole, closer at the crack
    cos, sin = z.real, z.imag
    matrix = np.array([np.hstack([xx * cos + xy * sin, xy * cos + yy * sin]) for xx, yy, xy in stress(z, c, terms)]).T
    given = np.zeros(2 * terms)
    given[0], given[terms] = across, (along - across) / 2  # at infinity yy = A_0, xx = A_0 + 2 B_0
    free = [k for k in range(2 * terms) if k not in (0, terms)]
    size = np.abs(matrix[:, free]).max(0)
    given[free] = np.linalg.lstsq(matrix[:, free] / size, -matrix @ given, rcond=1e-14)[0] / size
    return np.sqrt(c / a) * given[:terms] @ c ** (-2.0 * np.arange(terms)), np.abs(matrix @ given).max()


print("a_over_R,across,along,pressure,traction")
for text in sys.argv[2:]:
    across, off = solve(float(text), int(sys.argv[1]), 1, 0)
    along, off_along = solve(float(text), int(sys.argv[1]), 0, 1)
    print("%s,%.5f,%.5f,%.5f,%.0e" % (text, across, along, across + along, max(off, off_along)))
