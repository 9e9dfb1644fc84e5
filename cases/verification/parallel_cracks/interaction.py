#!/usr/bin/env python3
"""Parallel cracks under one pressure in an unbounded elastic body, in plane strain.

usage: interaction.py POINTS X,Y,A X,Y,A ...      (needs numpy)
Each crack lies along x; X, Y is its middle, A its half length. Each is a row of edge dislocations, of opening and of
sliding, with density B(t)/sqrt(1 - t^2); their stresses free the faces of shear and load them by the pressure
(Gauss-Chebyshev quadrature). Prints for each crack its opening in the middle and its volume over Sneddon's, 4 p a/E'
and 2 pi p a^2/E', and K_I and K_II of the left and the right tip over p sqrt(pi a).
"""
import sys

import numpy as np


def stress(x, y):
    """Stress yy and xy over E'/(4 pi) of a dislocation that opens, then of one that slides."""
    r4 = (x * x + y * y) ** 2
    return x * (x * x + 3 * y * y) / r4, y * (x * x - y * y) / r4, y * (x * x - y * y) / r4, x * (x * x - y * y) / r4


def series(density, angle):
    """c_m of the density as a sum of c_m T_m."""
    m, n = np.arange(len(density)), len(density)
    c = 2 / n * np.cos(np.outer(m, angle)) @ density
    c[0] /= 2
    return m, c


def solve(cracks, n):
    k = np.arange(1, n + 1)
    angle = np.pi * (k - 0.5) / n
    at, given = np.cos(angle), np.cos(np.pi * k[:-1] / n)  # of dislocations, of stresses
    rows, right = [], []
    for i, (x, y, a) in enumerate(cracks):
        yy, xy = [], []
        for u, v, b in cracks:
            of = stress(x + a * given[:, None] - u - b * at[None, :], y - v)
            weight = b / (4 * n)  # pi/n of the quadrature, 1/(4 pi) of the stresses, E' = 1
            yy += [weight * of[0], weight * of[2]]
            xy += [weight * of[1], weight * of[3]]
        closed = np.zeros((2, 2 * len(cracks) * n))  # at both ends there is no jump
        closed[0, 2 * i * n : (2 * i + 1) * n] = closed[1, (2 * i + 1) * n : (2 * i + 2) * n] = 1
        rows += [np.hstack(yy), np.hstack(xy), closed]
        right += [-np.ones(n - 1), np.zeros(n + 1)]
    density = np.linalg.solve(np.vstack(rows), np.hstack(right)).reshape(len(cracks), 2, n)
    for opens, slides in density:
        (m, c), (_, s) = series(opens, angle), series(slides, angle)
        opening = (c[1:] * np.sin(m[1:] * np.pi / 2) / m[1:]).sum() / 4
        volume = (opens * at).sum() / (2 * n)
        tips = [abs((of * side**m).sum()) / 4 for of in (c, s) for side in (-1.0, 1.0)]
        yield abs(opening), abs(volume), *tips


cracks = [tuple(float(v) for v in text.split(",")) for text in sys.argv[2:]]
for line in solve(cracks, int(sys.argv[1])):
    print("opening %.6f, volume %.6f, K_I %.6f %.6f, K_II %.6f %.6f" % line)
