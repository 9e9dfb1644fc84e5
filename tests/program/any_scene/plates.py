"""Plates: peridynamic ones, through stages, and element-free ones, solved at once."""
from . import solids, stages
from .values import box, chance, number, ramp, vector


def shape(r, centre, half):
    kind = r.choice(["rectangle", "rectangle", "disc", "polygon"])
    s = {"shape": kind}
    if kind == "rectangle":
        s.update(box(centre, half))
        if chance(r, 0.2):
            s["rotation"] = {"angle": number(r, -60, 60)}
    elif kind == "disc":
        s.update({"centre": centre, "radius": min(half)})
    else:
        x, y = centre
        a, b = half
        s["outline"] = [[round(x - a, 4), round(y - b, 4)], [round(x + a, 4), round(y - 0.7 * b, 4)],
                        [x, round(y + b, 4)]]
        if chance(r, 0.5):
            s["outline"] = [{"at": [x, y], "turn": "straight"},
                            {"at": [round(x + b, 4), y], "turn": "left", "centre": [x, y]}, [x, round(y + b, 4)]]
    return s


def body(r, size, number_of, index, names):
    centre = [number(r, (index + 0.48) / number_of * size[0], (index + 0.52) / number_of * size[0]),
              number(r, 0.45 * size[1], 0.55 * size[1])]
    half = [round(0.38 * size[0] / number_of, 4), number(r, 0.25 * size[1], 0.4 * size[1])]
    b = {"name": f"b{index}", "material": r.choice(names), **shape(r, centre, half)}
    if chance(r, 0.2):
        b["holes"] = [{"shape": "disc", "centre": [round(c + 0.3, 4) for c in centre], "radius": 1.1}]
    if chance(r, 0.2):
        kind = r.choice(["hexagonal", "perturbed", "perturbed", "centroidal", "random"])
        b["arrangement"] = {"kind": kind, "seed": r.randrange(5)}
        if kind == "perturbed":
            b["arrangement"]["perturbation"] = 0.2
    if chance(r, 0.2):
        b["velocity"] = vector(r, 0.2, 2)
    return b, centre, half


def edge_load(r, centre, half):
    (x, y), (a, b) = centre, half
    top = round(y + b, 4)
    load = {"edge": {"from": [round(x - a + 0.0031, 4), top], "to": [round(x + a, 4), top]}}
    load["traction"] = vector(r, 0.5, 2)
    if chance(r, 0.3):
        load["depth"] = "horizon"
    return load


def refinement(r, centre):
    f = {"levels": r.choice([1, 1, 2]), "every": r.choice([2, 5])}
    if chance(r, 0.3):
        f["energy"], f["damage"] = "off", 0.2
    if chance(r, 0.3):
        f["start"] = [{**box(centre, 1.6), "level": 1}]
    if chance(r, 0.3):
        f.update(box(centre, 4))
    if chance(r, 0.3):
        f["horizon"] = "kept"
    elif chance(r, 0.4):
        f["interface"] = "corrected"
    if chance(r, 0.4):
        f["held"] = "refine"
    if chance(r, 0.2):
        f["from"] = 0.1
    return f


def acting(r, s, centre, half):
    x, y = centre
    a, b = half
    if chance(r, 0.5):
        at = round(x + 0.013, 4)
        s["cracks"] = [{"points": [[at, round(y - b / 2, 4)], [at, round(y + 0.013, 4)]]}]
        if chance(r, 0.3):
            s["cracks"][0]["points"].append([round(at + 1.5, 4), round(y + 1, 4)])
    if chance(r, 0.5):
        at = y - b if s["bodies"][0]["shape"] == "rectangle" else y
        k = {**box([x, at], [a, 1.2]), "directions": r.choice(["x", "y", "xy"])}
        if chance(r, 0.5):
            solids.drive(r, k, {"velocity": 0.05, "displacement": 0.02}, "xy")
        s["constraints"] = [k]
    if chance(r, 0.3):
        s["loads"] = [{**box(centre, 2), "force": vector(r, 0.2, 2)}]
    if s["bodies"][0]["shape"] == "rectangle" and "rotation" not in s["bodies"][0] and chance(r, 0.6):
        s.setdefault("loads", []).append(edge_load(r, centre, half))
    for load in s.get("loads", []):
        if chance(r, 0.4):
            load["time"] = ramp(r)
    if chance(r, 0.2):
        s["unbreakable"] = [box([x, y + 1], 1.5)]
    if chance(r, 0.15):
        s["initial"] = [{"shape": "gaussian", "along": "x", "centre": x, "width": 3}]
        s["initial"][0]["displacement"] = vector(r, 0.05, 2)
    if chance(r, 0.15):
        s["indenters"] = [{"shape": "sphere", "centre": [x, round(y + b + 2, 4)], "radius": 2.5, "velocity": [0, -0.1],
                           "stiffness": r.choice([0.01, 0.1])}]
    if chance(r, 0.2):
        s["body_force"] = vector(r, 0.02, 2)
    if chance(r, 0.3):
        s["contact"] = solids.contact(r)


def plate(r):
    """A plate of bonds."""
    size = [r.choice([12, 16, 20, 24]) for _ in range(2)]
    names = "ab"[: r.choice([1, 1, 2])]
    s = {"spacing": 1, "model": r.choice(["plane_stress", "plane_strain"]),
         "materials": [solids.material(r, name, True) for name in names]}
    count = r.choice([1, 1, 2])
    bodies = [body(r, size, count, k, names) for k in range(count)]
    s["bodies"] = [b for b, _, _ in bodies]
    if chance(r, 0.3):
        s["thickness"] = r.choice([0.5, 2])
    if chance(r, 0.3):
        s["surface_correction"] = r.choice(["none", "volume"])
    if chance(r, 0.2):
        s["lattice_offset"] = vector(r, 0.5, 2)
    if chance(r, 0.2):
        s["partial_volume"] = r.choice(["ramp", "ramp_cut"])
    if chance(r, 0.1):
        s["horizons"] = "one_sided"
    if count > 1 and chance(r, 0.3):
        solids.side_by_side(s)
        s["interfaces"] = [{"between": ["b0", "b1"], "fracture_energy": r.choice([1e-3, 1e-2])}]
    half = bodies[0][2]
    acting(r, s, *bodies[0][1:])
    if chance(r, 0.25) and "interfaces" not in s:
        s["refinement"] = refinement(r, bodies[0][1])
        for part in s["materials"] + s["bodies"]:
            part.pop("breakage", None)
            part.pop("arrangement", None)
            part.pop("tensile_strength", None)
    scene = {"domain": {"size": size}, "solid": s}
    if chance(r, 0.2):
        scene["domain"]["periodic"] = [chance(r, 0.5), chance(r, 0.5)]
    may_relax = not any("velocity" in k for k in s.get("constraints", []) + s["bodies"]) and "indenters" not in s
    held = [k for k in s.get("constraints", []) if k["directions"] == "xy"]
    may_relax = may_relax and held and not any("time" in k for k in held) and len(bodies) == 1
    scene["stages"] = [stages.stage(r, k, False, False, False, may_relax) for k in range(r.choice([1, 2, 3]))]
    stages.times_from(r, scene)
    if "refinement" in s:
        for part in scene["stages"]:
            part["damping_absolute"] = 0
        s.pop("horizons", None)
    scene["output"] = stages.output(r, scene, bodies[0][1])
    if "cracks" in s and chance(r, 0.4) and min(half) > 5:
        for m in s["materials"]:
            m["horizon_ratio"] = 2
        scene["output"]["intensity"] = {"radii": [4, 4.5], "every": 4}
    return scene


def element_free(r):
    """A plate that is solved at once."""
    w, h = r.choice([[6, 8], [8, 8], [8, 6]])
    s = {"spacing": 1, "model": r.choice(["plane_stress", "plane_strain"]), "method": "element_free",
         "lattice_offset": [r.choice([0, 0.5]), number(r, -0.1, 0.1)],
         "materials": [{"name": "a", "youngs_modulus": 100, "density": 1, "poisson_ratio": number(r, 0, 0.4)}],
         "bodies": [{"shape": "rectangle", "low": [0, 0], "high": [w, h]}]}
    y = round(h / 2 + number(r, -0.3, 0.3), 4)
    length = number(r, 0.3 * w, 0.5 * w)
    options = {"basis": r.choice(["linear", "sqrt_r", "tip"]), "weight": r.choice(["cubic", "quartic"]), "support": 2.8,
               "tip_levels": r.choice([0, 1, 2]), "crack": r.choice(["virtual", "diffraction", "visibility"]),
               "update": r.choice(["conjugate", "conjugate", "hestenes_powell"]), "tolerance": 1e-8}
    if chance(r, 0.8):
        s["cracks"] = [{"points": [[0, y], [length, y]]}]
    if chance(r, 0.2) and "cracks" not in s:
        s["bodies"][0]["holes"] = [{"shape": "disc", "centre": [w / 2, h / 2], "radius": 1.2}]
    if chance(r, 0.2):
        s["bodies"][0]["arrangement"] = {"kind": r.choice(["hexagonal", "centroidal"])}
    if "cracks" in s and options["basis"] != "tip" and options["crack"] != "diffraction" and chance(r, 0.4):
        options["growth"] = {"step": 0.6, "steps": 2, "toughness": 1}
    s["element_free"] = options
    s["constraints"] = [{"low": [-0.01, -0.01], "high": [0.01, 0.01]},
                        {"low": [w - 0.01, -0.01], "high": [w + 0.01, 0.01], "directions": "y"}]
    pull = vector(r, 1, 2)
    pull[1] = abs(pull[1]) + 0.2
    s["loads"] = [{"edge": {"from": [0, 0], "to": [w, 0]}, "traction": [-pull[0], -pull[1]]},
                  {"edge": {"from": [0, h], "to": [w, h]}, "traction": pull}]
    output = {"intensity": {"radii": [1.2, 1.4]}} if "cracks" in s and "growth" not in options else {}
    return {"domain": {"size": [w, h]}, "solid": s, "output": output}


def nonlocal_(r):
    """A nonlocal problem, solved at once."""
    n = {"dimension": r.choice([1, 2, 3]), "exponent": r.choice([0, 1, 2.5]), "horizon": number(r, 0.4, 0.6),
         "inner_radius": 1, "outer_radius": number(r, 1.6, 1.8), "spacing": r.choice([0.2, 0.25])}
    kind = r.choice(["lattice", "hexagonal", "perturbed", "centroidal", "random"])
    n["arrangement"] = {"kind": kind, **({"perturbation": 0.3} if kind == "perturbed" else {})}
    if kind in ("hexagonal", "centroidal", "random") and chance(r, 0.5):
        n["arrangement"]["volume"] = "cell"
    return {"nonlocal": n}
