"""Random numbers of scenes: rounded, so that a scene is short."""


def number(r, low, high):
    return round(r.uniform(low, high), 4)


def vector(r, size, dimensions=3):
    return [number(r, -size, size) for _ in range(dimensions)]


def chance(r, probability):
    return r.random() < probability


def box(centre, half, reach=0.0031):
    """A region about a centre. Its low corner is moved, so that no lattice point is on its border."""
    half = half if isinstance(half, list) else [half] * len(centre)
    return {
        "low": [round(c - h + reach, 4) for c, h in zip(centre, half)],
        "high": [round(c + h, 4) for c, h in zip(centre, half)],
    }


def ramp(r):
    return [[0, 0], [number(r, 0.2, 2), 1]]
