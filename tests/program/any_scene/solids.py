"""Solids in space: materials, bodies, and what acts on them."""
from .values import box, chance, number, ramp, vector


def material(r, name, may_break):
    m = {"name": name, "youngs_modulus": r.choice([10, 100, 1000]), "density": r.choice([0.5, 1, 2, 5])}
    if may_break and chance(r, 0.7):
        m.update(strength(r, m["youngs_modulus"]))
    if chance(r, 0.3):
        m["horizon_ratio"] = r.choice([2, 2.5, 3.2])
    if chance(r, 0.3):
        m["micromodulus"] = r.choice(["conical", "exponential"])
    if chance(r, 0.2) and "s00" not in m.get("breakage", {}) and not (may_break and "micromodulus" in m):
        m["poisson_ratio"] = r.choice([0.1, 0.3])
    return m


def strength(r, modulus):
    """One of the ways to say when bonds break. Stretches of some 1e-3 to 1e-1."""
    stretch = r.choice([1e-3, 1e-2, 1e-1])
    energy = float(f"{2 * modulus * stretch**2:.3g}")
    tension = float(f"{modulus * stretch:.3g}")
    return r.choice([
        {"fracture_energy": energy},
        {"fracture_energy": energy},
        {"toughness": float(f"{(energy * modulus) ** 0.5:.3g}")},
        {"tensile_strength": tension},
        {"fracture_energy": 10 * energy, "breakage": {"law": "bilinear", "tensile_strength": tension}},
        {"breakage": {"law": "brittle", "s00": stretch, "alpha": r.choice([0, 0.25])}},
    ])


def turned(r, centre):
    turn = {"axis": r.choice([[0, 0, 1], [1, 1, 0], [1, 2, 3]]), "angle": number(r, -90, 90)}
    if chance(r, 0.3):
        turn = {"axes": [[1, 1, 1], [-1, 1, 0]]}
    if chance(r, 0.2):
        turn["about"] = [round(c + 0.5, 4) for c in centre]
    return turn


def shape(r, centre, room, cells):
    """A box, sphere, cylinder, ellipsoid or list of spheres that reaches no farther than `room` along x."""
    kind = r.choice(["box", "box", "sphere", "cylinder", "ellipsoid", "spheres"])
    s = {"shape": kind}
    if kind == "box":
        s.update(box(centre, [min(room, number(r, 1.5, 4))] + [number(r, 1.5, 0.35 * n) for n in cells[1:]]))
    elif kind == "spheres":
        size = min(room, number(r, 1.5, 3.5))
        other = [round(centre[0] + 0.1, 4), round(centre[1] + 0.8 * size, 4), centre[2]]
        s["spheres"] = [[*centre, size], [*other, round(0.8 * size, 4)]]
    else:
        s["centre"] = centre
        if kind == "ellipsoid":
            s["radii"] = [min(room, number(r, 1.5, 4)) for _ in range(3)]
        else:
            s["radius"] = min(room, number(r, 1.5, 4))
        if kind == "cylinder":
            s["axis"], s["length"] = r.choice("yz"), number(r, 4, 10)
    if kind in ("box", "cylinder", "ellipsoid") and chance(r, 0.2):
        s["rotation"] = turned(r, centre)
    return s


def body(r, cells, number_of, index, names, periodic):
    """Bodies stand side by side along x; across a periodic side some lie on both of its ends."""
    centre = [number(r, 0.35 * n, 0.65 * n) for n in cells]
    for d in (1, 2):
        if periodic[d] and chance(r, 0.4):
            centre[d] = number(r, 0, cells[d])
    centre[0] = number(r, (index + 0.45) / number_of * cells[0], (index + 0.55) / number_of * cells[0])
    if number_of == 1 and periodic[0] and chance(r, 0.4):
        centre[0] = number(r, 0, cells[0])
    b = {"name": f"b{index}", "material": r.choice(names)}
    b.update(shape(r, centre, round(0.33 * cells[0] / number_of, 4), cells))
    if chance(r, 0.15):
        b["holes"] = [{"shape": "sphere", "centre": [round(c + 0.013, 4) for c in centre], "radius": 1.2}]
    if chance(r, 0.1):
        b["pieces"] = [{"shape": "sphere", "centre": [centre[0], round(centre[1] + 2, 4), centre[2]], "radius": 1.6}]
        if chance(r, 0.3):
            b["contacts"] = "broken"
    if chance(r, 0.1):
        b["cavities"] = {"period": 4, "radius": number(r, 1, 2.2), "centre": centre}
    if chance(r, 0.1) and "contacts" not in b:
        kind = r.choice(["hexagonal", "perturbed", "centroidal", "random"])
        b["arrangement"] = {"kind": kind, **({"perturbation": 0.2} if kind == "perturbed" else {})}
        if kind != "perturbed" and chance(r, 0.5):
            b["arrangement"]["volume"] = "cell"
    if chance(r, 0.3):
        b["velocity"] = vector(r, 0.2)
    return b, centre


def drive(r, k, sizes, axes):
    """Prescribes a constraint's velocity or displacement, up to these sizes."""
    given = r.choice(["velocity", "displacement"])
    size = sizes[given]
    k[given] = [number(r, -size, size) if c in k["directions"] else 0 for c in axes]
    if given == "displacement" or chance(r, 0.3):
        k["time"] = ramp(r)


def constraint(r, centre):
    k = {**box(centre, 1.2), "directions": r.choice(["x", "yz", "xyz"])}
    if chance(r, 0.4):
        drive(r, k, {"velocity": 0.02, "displacement": 0.005}, "xyz")
    return k


def contact(r):
    c = {"enabled": True}
    if chance(r, 0.2):
        c = {"enabled": False}
    elif chance(r, 0.7):
        c.update({"stiffness": r.choice([1, 15, 40]), "exponent": r.choice([1, 1, 2])})
        c["radius"] = r.choice([0.9, 1, 1.1])
    return c


def initial(r, centre):
    d = r.randrange(3)
    return {"shape": r.choice(["gaussian", "sine"]), "along": "xyz"[d], "centre": centre[d], "width": number(r, 2, 6),
            "displacement": vector(r, 0.01)}


def side_by_side(s):
    """Makes the first two bodies boxes that touch, and their materials such that they can be bonded."""
    for m in s["materials"]:
        m.pop("breakage", None)
    first, second = s["bodies"][0], s["bodies"][1]
    n = 2 if "model" in s else 3
    if "low" not in first:
        first.update(box(first.pop("centre", [5] * n), 2.5))
    for b, name in ((first, "b0"), (second, "b1")):
        keep = {"name": name, "material": b["material"], "shape": "box" if n == 3 else "rectangle"}
        low, high = first["low"], first["high"]
        b.clear()
        b.update({**keep, "low": low, "high": high})
    second["low"] = [first["high"][0], *first["low"][1:]]
    second["high"] = [round(first["high"][0] + 3, 4), *first["high"][1:]]


def acting(r, s, centre, cells, may_break):
    """Cracks, constraints, loads and the other lists of the solid."""
    x, y, z = centre
    if may_break and chance(r, 0.3):
        at, from_ = round(x + 0.013, 4), round(y - 0.7, 4)
        s["cracks"] = [{"points": [[at, from_, -9], [at, 99, -9], [at, 99, 99], [at, from_, 99]]}]
    if chance(r, 0.4):
        s["constraints"] = [constraint(r, centre)]
        if chance(r, 0.3):
            s["constraints"].append(constraint(r, [round(c + 1.5, 4) for c in centre]))
    if chance(r, 0.4):
        s["loads"] = [{**box(centre, 3), "force": vector(r, 0.02)}]
        if chance(r, 0.5):
            s["loads"][0]["time"] = ramp(r)
    if may_break and chance(r, 0.2):
        s["unbreakable"] = [box([x, y + 1, z], 1.5)]
    if chance(r, 0.15):
        s["initial"] = [initial(r, centre)]
    if chance(r, 0.15):
        s["indenters"] = [{"shape": "sphere", "centre": [x, round(y + 4, 4), z], "radius": 2.5,
                           "velocity": [0, -0.05, 0], "stiffness": r.choice([0.01, 0.1])}]
    if chance(r, 0.3):
        s["body_force"] = vector(r, 0.02)
    if chance(r, 0.3):
        s["contact"] = contact(r)


def solid(r, cells, may_break, periodic):
    names = "ab"[: r.choice([1, 1, 2])]
    s = {"materials": [material(r, name, may_break) for name in names]}
    count = r.choice([1, 1, 2, 3])
    bodies = [body(r, cells, count, k, names, periodic) for k in range(count)]
    s["bodies"] = [b for b, _ in bodies]
    if chance(r, 0.3):
        s["surface_correction"] = r.choice(["none", "volume"])
    if chance(r, 0.2):
        s["lattice_offset"] = vector(r, 0.5)
    if chance(r, 0.15) and all("micromodulus" not in m for m in s["materials"]):
        s["precision"] = "mixed"
    if chance(r, 0.1):
        s["partial_volume"] = "ramp_cut"
    if chance(r, 0.1):
        s["horizons"] = "one_sided"
    if count > 1 and chance(r, 0.3):
        side_by_side(s)
        s["interfaces"] = [{"between": ["b0", "b1"], "fracture_energy": r.choice([1e-3, 1e-2, float("inf")])}]
    acting(r, s, bodies[0][1], cells, may_break)
    return s
