#!/usr/bin/env python3
"""T-stress and K of an edge crack in a plate of width 1 under tension 1 by boundary collocation of Williams' series.

usage: collocation.py A HALF_HEIGHT TERMS...      (needs numpy)
The stress is a sum of eigenfunctions about the tip, which leave the faces free. Least squares over points of the border
give their coefficients. Prints for each number of terms K/sqrt(pi a), T and the largest error of a traction.
"""
import sys

import numpy as np


def terms(x, y, n_most, scale):
    """Stress xx, yy, xy of the eigenfunctions of mode I at points, [points][terms]."""
    r, t = np.hypot(x, y) / scale, np.arctan2(y, x)
    xx, yy, xy = [], [], []
    for n in range(1, n_most + 1):
        h, sign = n / 2, (-1) ** n
        c = h * r ** (h - 1)
        xx.append(c * ((2 + h + sign) * np.cos((h - 1) * t) - (h - 1) * np.cos((h - 3) * t)))
        yy.append(c * ((2 - h - sign) * np.cos((h - 1) * t) + (h - 1) * np.cos((h - 3) * t)))
        xy.append(c * (-(h + sign) * np.sin((h - 1) * t) + (h - 1) * np.sin((h - 3) * t)))
    return np.array(xx).T, np.array(yy).T, np.array(xy).T


def side(p, q, n):
    """Points from p to q, closer at the ends."""
    s = (1 - np.cos(np.pi * (np.arange(n) + 0.5) / n)) / 2
    return p[0] + (q[0] - p[0]) * s, p[1] + (q[1] - p[1]) * s


def solve(a, high, n):
    """K/sqrt(pi a), T, largest error of a traction; the upper half of the plate, the tip at the origin."""
    scale, rows, given = np.hypot(1 - a, high), [], []
    for p, q, normal, load in (
        ((-a, 0), (-a, high), "x", 0),
        ((1 - a, 0), (1 - a, high), "x", 0),
        ((-a, high), (1 - a, high), "y", 1),
    ):
        x, y = side(p, q, 4 * n)
        xx, yy, xy = terms(x, y, n, scale)
        rows += [xx if normal == "x" else yy, xy]
        given += [0 * x + load, 0 * x]
    matrix, right = np.vstack(rows), np.concatenate(given)
    size = np.abs(matrix).max(0)
    c = np.linalg.lstsq(matrix / size, right, rcond=1e-16)[0] / size
    return c[0] * np.sqrt(2 * scale / a), 4 * c[1], np.abs(matrix @ c - right).max()


form = "%s terms: K/sqrt(pi a) %.4f, T %.4f, traction off by %.3f"
for count in sys.argv[3:]:
    print(form % (count, *solve(float(sys.argv[1]), float(sys.argv[2]), int(count))))
