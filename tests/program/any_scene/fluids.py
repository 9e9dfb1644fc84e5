"""Fluids of random scenes: sides, drives and initial flows."""
from .values import chance, number, vector


def pair_of_sides(r, d, kind):
    low, high = {"type": kind}, {"type": kind}
    if kind == "open":
        low, high = {"type": "inflow", "bulk_velocity": number(r, 0.02, 0.2)}, {"type": "outflow"}
        if chance(r, 0.3):
            high = {"type": "pressure", "pressure": number(r, 0, 0.1)}
    if kind == "pressure":
        low["pressure"] = number(r, 0, 0.1)
    if kind == "wall" and chance(r, 0.3):
        high["velocity"] = [number(r, -0.2, 0.2) if c == (d + 1) % 3 else 0 for c in range(3)]
    if kind == "general":
        across = {name: r.choice(["dirichlet", "neumann"]) for name in "uvw"}
        across["uvw"[d]] = "dirichlet"
        low = {"type": "general", **across, "p": "neumann"}
        high = {"type": "general", **across, "p": "neumann"}
        low["velocity"] = [0 if c == d else number(r, -0.05, 0.05) for c in range(3)]
    return (low, high) if chance(r, 0.7) else (high, low)


def sides(r):
    """The sides, and the directions that are periodic: all of them, or some; one direction at most is open."""
    found, periodic, open_ = {}, [False] * 3, chance(r, 0.5) and r.randrange(3)
    everywhere = open_ is False and chance(r, 0.3)
    for d, axis in enumerate("xyz"):
        kind = "periodic" if everywhere else r.choice(["periodic", "periodic", "slip", "wall", "wall", "general"])
        if open_ is not False and d == open_:
            kind = r.choice(["open", "open", "pressure"])
        periodic[d] = kind == "periodic"
        found[axis + "_low"], found[axis + "_high"] = pair_of_sides(r, d, kind)
    for d, axis in enumerate("xyz"):
        for side in (found[axis + "_low"], found[axis + "_high"]):
            walls = any(found[a + "_low"]["type"] == "wall" == found[a + "_high"]["type"] for a in "xyz" if a != axis)
            if side["type"] == "inflow" and walls and chance(r, 0.5):
                side["profile"] = "poiseuille"
    return found, periodic


def initial(r, periodic, sides_):
    if chance(r, 0.5):
        return {"velocity": [number(r, -0.2, 0.2) if periodic[d] else 0 for d in range(3)]}
    closed = [sides_[a + "_low"]["type"] in ("periodic", "slip") for a in "xyz"]
    axes = [w for w in ("xy", "xz", "yz", "xyz") if all(closed["xyz".index(c)] for c in w)]
    return {"taylor_green": {"velocity": number(r, 0.05, 0.2), "axes": r.choice(axes)}} if axes else {}


def driving(r, periodic):
    axes = [a for a, p in zip("xyz", periodic) if p]
    d = {"type": r.choice(["pressure_gradient", "bulk_velocity"]), "value": number(r, 0.01, 0.1)}
    if d["type"] == "pressure_gradient" and chance(r, 0.3):
        d["along"] = [number(r, -1, 1) if p else 0 for p in periodic]
    else:
        d["direction"] = r.choice(axes)
    if d["type"] == "pressure_gradient" and chance(r, 0.3):
        d["frequency"] = number(r, 0.05, 1)
    return d


def fluid(r):
    """The fluid, and the directions that are periodic."""
    around, periodic = sides(r)
    f = {"density": r.choice([0.5, 1]), "viscosity": r.choice([0.02, 0.1, 0.5]), "sides": around}
    if chance(r, 0.5):
        f["initial"] = initial(r, periodic, around)
    if chance(r, 0.3):
        f["body_force"] = vector(r, 0.02)
    if any(periodic) and chance(r, 0.4):
        f["driving"] = driving(r, periodic)
    if all(s["type"] != "pressure" for s in around.values()) and chance(r, 0.2):
        f["diffusion"] = "implicit"
    elif chance(r, 0.15):
        f["projection"] = "last_stage"
    return f, periodic
