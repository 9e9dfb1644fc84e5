"""Fluid in cracks: in plates and blocks, dry or in a flow, with and without pores."""
from . import stages
from .values import box, chance, number


def injection(r, centre, half):
    i = box(centre, half)
    if chance(r, 0.6):
        i["rate"] = r.choice([0.001, 0.01, 0.05]) * (-1 if chance(r, 0.1) else 1)
    else:
        i["pressure"] = r.choice([0.05, 0.2, 0.5])
    if chance(r, 0.6):
        i["time"] = [[0, 0], [number(r, 0.1, 1), 1]]
    return i


def crack_fluid(r, centre, size, has_flow):
    f = {"least_pressure": r.choice([-0.5, -5]) if has_flow or chance(r, 0.4) else 0}
    if not has_flow:
        f["viscosity"] = r.choice([1e-4, 1e-3, 1e-2])
    if chance(r, 0.4):
        f["compressibility"] = r.choice([1e-4, 1e-2])
    if chance(r, 0.2):
        f["least_aperture"] = r.choice([1e-3, 1e-2])
    if not has_flow and chance(r, 0.3):
        f["pores"] = {"permeability": r.choice([0, 1e-4, 1e-3]), "biot": r.choice([0, 0.5, 0.8, 1])}
        if chance(r, 0.7) or f["pores"]["permeability"] == 0:
            f["pores"]["modulus"] = r.choice([100, 1000])
    elif chance(r, 0.3):
        f["leak_off"] = r.choice([1e-4, 1e-3])
    if not has_flow or chance(r, 0.5):
        f["injections"] = [injection(r, centre, 1.6)]
        if "pores" in f and chance(r, 0.6):
            f["injections"].append({"low": [-1] * len(size), "high": [3] + [n + 1 for n in size[1:]], "pressure": 0})
        if chance(r, 0.2):
            f["injections"].append(injection(r, [centre[0], round(centre[1] + 1, 4), *centre[2:]], 1.2))
    return f


def material(r):
    modulus, stretch = r.choice([10, 100, 1000]), r.choice([1e-2, 1e-1])
    m = {"name": "a", "youngs_modulus": modulus, "density": r.choice([1, 2, 5]),
         "fracture_energy": float(f"{2 * modulus * stretch**2:.3g}")}
    if chance(r, 0.2):
        m["horizon_ratio"] = 2.5
    if chance(r, 0.2):
        m["micromodulus"] = "conical"
    if chance(r, 0.1) and "micromodulus" not in m:
        m["poisson_ratio"] = 0.2
    if chance(r, 0.2):
        m["fracture_energy"] *= 10
        m["breakage"] = {"law": "bilinear", "tensile_strength": modulus * stretch}
    return m


def pumping(r, scene):
    found = []
    for k in range(r.choice([1, 2, 3])):
        s = {"name": f"s{k}", "steps": r.choice([5, 8, 12])}
        stages.lengths(r, s, "fluid" in scene)
        stages.motion(r, s)
        if chance(r, 0.75):
            s["crack_fluid"] = True
            s.pop("integrator", None)
        found.append(s)
    if not any("crack_fluid" in s for s in found):
        found[-1]["crack_fluid"] = True
        found[-1].pop("integrator", None)
    return found


def dry(r):
    """A plate or a block whose only fluid is that of its cracks."""
    flat = chance(r, 0.6)
    size = [r.choice([14, 16, 20]) for _ in range(2)] if flat else [12, 12, 12]
    centre = [number(r, 0.45 * n, 0.55 * n) for n in size]
    half = [round(0.4 * n, 4) for n in size]
    s = {"spacing": 1, "materials": [material(r)],
         "bodies": [{"shape": "rectangle" if flat else "box", **box(centre, half)}]}
    if flat:
        s["model"] = r.choice(["plane_stress", "plane_strain"])
        x, y = centre
        s["cracks"] = [{"points": [[round(x - 2.2, 4), round(y + 0.013, 4)], [round(x + 2.3, 4), round(y + 0.013, 4)]]}]
    else:
        x, y, z = centre
        a, b, h = 2.3, 2.2, round(y + 0.013, 4)
        s["cracks"] = [{"points": [[x - a, h, z - b], [x + a, h, z - b], [x + a, h, z + b], [x - a, h, z + b]]}]
    if chance(r, 0.3):
        s["constraints"] = [{**box([centre[0], centre[1] - half[1], *centre[2:]], [20, 1.2, 20][: len(size)])}]
    scene = {"domain": {"size": size}, "solid": s}
    if chance(r, 0.2):
        scene["domain"]["periodic"] = [True] + [False] * (len(size) - 1)
        s["bodies"][0]["low"][0], s["bodies"][0]["high"][0] = 0, size[0]
    scene["crack_fluid"] = crack_fluid(r, centre, size, False)
    scene["stages"] = pumping(r, scene)
    for injection_ in scene["crack_fluid"].get("injections", []):
        if "time" in injection_ and chance(r, 0.3):
            injection_["time_from"] = scene["stages"][-1]["name"]
    scene["output"] = stages.output(r, scene, centre)
    return scene


def in_a_flow(r):
    """A notched block in a channel."""
    cells = [r.choice([12, 14, 16]), 12, r.choice([10, 12])]
    centre = [number(r, 0.45 * n, 0.55 * n) for n in cells]
    x, y, z = centre
    s = {"materials": [material(r)], "bodies": [{"shape": "box", **box(centre, [3.5, 3.5, 2.6])}]}
    at = round(x + 0.013, 4)
    s["cracks"] = [{"points": [[at, y, -9], [at, 99, -9], [at, 99, 99], [at, y, 99]]}]
    if chance(r, 0.7):
        s["constraints"] = [box([x, y - 3, z], [5, 1.2, 5])]
    if chance(r, 0.3):
        s["body_force"] = [0, number(r, -0.02, 0.02), 0]
    drive = r.choice([
        ({"type": "inflow", "bulk_velocity": 0.1}, {"type": "outflow"}),
        ({"type": "pressure", "pressure": 0.1}, {"type": "pressure"}),
    ])
    wall = r.choice(["wall", "slip"])
    scene = {"domain": {"size": cells, "cells": cells},
             "fluid": {"density": 1, "viscosity": r.choice([0.02, 0.1, 0.5]), "sides": {
                 "x_low": drive[0], "x_high": drive[1], "y_low": {"type": wall}, "y_high": {"type": wall},
                 "z_low": {"type": "periodic"}, "z_high": {"type": "periodic"}}}, "solid": s}
    if chance(r, 0.4):
        scene["coupling"] = {"load": "probe"}
    scene["crack_fluid"] = crack_fluid(r, [x, y + 1.7, z], cells, True)
    scene["stages"] = pumping(r, scene)
    scene["output"] = stages.output(r, scene, centre)
    return scene


def scene(r):
    return in_a_flow(r) if chance(r, 0.35) else dry(r)
