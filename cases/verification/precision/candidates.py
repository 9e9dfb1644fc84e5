#!/usr/bin/env python3
"""Error of the bond forces of a lattice block by ways to compute them in single precision, against double.

A block of SIDE^3 particles with a horizon of 3 spacings is strained by a smooth random field, turned as a whole and
moved. Printed: the rms error of the acceleration over the rms of the accelerations' halves (the sum over the bonds to
one side of a particle, which a stress makes), and the total force over the sum of the halves' magnitudes.
"""
import sys
import numpy as np

SIDE = int(sys.argv[1]) if len(sys.argv) > 1 else 16
single, double = np.float32, np.float64
rng = np.random.default_rng(1)


def family():
    """Offsets |xi| < 3.5 of the later half of the family, in the order of x, y, z."""
    r = range(-3, 4)
    of = [(x, y, z) for z in r for y in r for x in r if 0 < x * x + y * y + z * z < 3.5**2 and (z, y, x) > (0, 0, 0)]
    return np.array(of)


def rotation(angle):
    axis = np.array([1, 2, 3]) / np.sqrt(14)
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def displacement(strain, angle, shift):
    """[3, z, y, x] of X = R (X0 + u) + shift, lengths in spacings."""
    z, y, x = np.meshgrid(*[np.arange(SIDE, dtype=double)] * 3, indexing='ij')
    x0 = np.stack([x, y, z])
    u = np.zeros_like(x0)
    for _ in range(6):
        k, phase = rng.normal(size=3) * 2 * np.pi / SIDE, rng.uniform(0, 2 * np.pi)
        u += rng.normal(size=3)[:, None, None, None] * np.sin(np.tensordot(k, x0, 1) + phase) / np.linalg.norm(k)
    u *= strain / 3
    turn = rotation(angle)
    return np.einsum('ij,jzyx->izyx', turn - np.eye(3), x0) + np.einsum('ij,jzyx->izyx', turn, u) + shift


def halves(offset):
    """Slices of the sites that have a neighbour at the offset, and of these neighbours."""
    def cut(o):
        return slice(max(0, -o), SIDE - max(0, o)), slice(max(0, o), SIDE - max(0, -o))
    here, there = zip(*[cut(o) for o in offset[::-1]])
    return (slice(None),) + here, (slice(None),) + there


def differences(way, d):
    """A function of the two slices that gives eta in the way's precision."""
    if way == 'double':
        return lambda h, l: d[l] - d[h]
    if way == 'displacement in single':
        f = d.astype(single)
        return lambda h, l: f[l] - f[h]
    if way == 'relative to the block':
        f = (d - d.mean(axis=(1, 2, 3), keepdims=True)).astype(single)
        return lambda h, l: f[l] - f[h]
    if way == 'pairs of singles':
        high = d.astype(single)
        low = (d - high).astype(single)
        return lambda h, l: (high[l] - high[h]) + (low[l] - low[h])
    return lambda h, l: (d[l] - d[h]).astype(single)


def sweep(d, way, sums, exact_eps=False):
    """Accelerations times a constant, and the forces of the bonds of one side alone."""
    real = double if way == 'double' else single
    own, back = np.zeros(d.shape, sums), np.zeros(d.shape, sums)
    eta_of = differences(way, d)
    for o in family():
        h, l = halves(o)
        xi, length2 = o.astype(real)[:, None, None, None], real(o @ o)
        eta = eta_of(h, l)
        if exact_eps:
            wide = d[l] - d[h]
            eps = ((wide * (2 * o.astype(double)[:, None, None, None] + wide)).sum(axis=0) / (o @ o)).astype(real)
        else:
            eps = (eta * (2 * xi + eta)).sum(axis=0) * (1 / length2)
        g = eps * (real(0.5) + eps * (real(-0.375) + eps * real(0.3125)))
        f = g * (1 / np.sqrt(length2)) * (xi + eta)
        own[h] += f
        back[l] -= f
    return own, back


WAYS = [('displacement in single', single, False), ('relative to the block', single, False),
        ('difference in double', single, False), ('pairs of singles', single, False),
        ('difference in double', double, False), ('difference and eps in double', single, True)]
STATES = [(1e-4, 0, 0), (1e-4, 0, 1e4), (1e-6, 0, 0), (1e-6, 0, 1e4), (1e-4, 0.01, 1e4), (1e-4, 0.3, 1e4),
          (1e-4, np.pi / 2, 1e4), (1e-4, np.pi, 1e4)]
print('| strain | turned, rad | moved, spacings | bonds | sums | error of a | total force |\n' + '|---' * 7 + '|')
for strain, angle, shift in STATES:
    d = displacement(strain, angle, shift)
    own, back = sweep(d, 'double', double)
    exact, scale = own + back, np.sqrt((own**2).sum() / SIDE**3)
    for way, sums, exact_eps in WAYS:
        own, back = sweep(d, 'difference in double' if exact_eps else way, sums, exact_eps)
        a = own.astype(double) + back.astype(double)
        error = np.sqrt(((a - exact)**2).sum() / SIDE**3) / scale
        total = np.linalg.norm(a.sum(axis=(1, 2, 3))) / (scale * SIDE**3)
        print(f'| {strain:g} | {angle:.3g} | {shift:g} | {way} | {np.dtype(sums).name} | {error:.1e} | {total:.1e} |')
