"""Stages and outputs of random scenes."""
from .values import chance, number


def lengths(r, s, has_fluid):
    """How long a stage and its steps are."""
    if chance(r, 0.2):
        s["duration"] = number(r, 0.05, 0.6)
        s["steps"] = 30
    if chance(r, 0.15):
        s["until"] = {"quantity": "rest", "change": 0.5, "kinetic": 0.5, "window": 3}
        s["steps"] = 40
    if chance(r, 0.2):
        s["time_step"] = r.choice([0.005, 0.02, 0.05]) if has_fluid else r.choice([0.01, 0.03])
    elif has_fluid and chance(r, 0.2):
        s["cfl"] = r.choice([0.2, 0.5])
    elif chance(r, 0.2):
        s["safety"] = r.choice([0.5, 0.8])
    if has_fluid and "time_step" not in s and chance(r, 0.1):
        s["substeps"] = r.choice([4, 7, 10])


def motion(r, s):
    """How the solid moves."""
    if chance(r, 0.4):
        s["integrator"] = r.choice(["rk3", "verlet"])
    if chance(r, 0.2) and "substeps" not in s:
        s["damping_relative"] = r.choice([1, 10])
    if chance(r, 0.2):
        s["damping_absolute"] = r.choice([0.1, 0.5, *(["auto"] if "until" in s else [])])
    if chance(r, 0.2):
        s["breakage"] = False


def relaxing(r, s):
    s["relax"] = True
    if chance(r, 0.6):
        s["increment"], s["steps"] = number(r, 0.05, 0.5), r.choice([2, 3, 4])
    else:
        s["steps"] = 1
    s["tolerance"] = r.choice([1e-3, 1e-4])


def stage(r, index, has_fluid, implicit, may_stand, may_relax=False):
    s = {"name": f"s{index}", "steps": r.choice([5, 8, 12, 20])}
    if may_stand and chance(r, 0.4):
        s["solid"] = "rigid"
        if chance(r, 0.3):
            s["until"] = {"quantity": "permeability", "change": 0.1, "window": 3}
            s["steps"] = 60
        return s
    if may_relax and chance(r, 0.3):
        relaxing(r, s)
        if chance(r, 0.2):
            s["breakage"] = False
        return s
    lengths(r, s, has_fluid)
    motion(r, s)
    if has_fluid and not implicit and chance(r, 0.25):
        s["fluid_integrator"] = "ab2"
    return s


def times_from(r, scene):
    """Lets the times of a load or constraint count from the start of a stage."""
    for part in scene.get("solid", {}).get("constraints", []) + scene.get("solid", {}).get("loads", []):
        if "time" in part and chance(r, 0.4):
            part["time_from"] = r.choice(scene["stages"])["name"]


def output(r, scene, centre):
    """All kinds of files."""
    o = {"series_every": r.choice([1, 1, 2]), "fields_every": r.choice([0, 5, 10])}
    o["checkpoint_every"] = r.choice([4, 7])
    plate = len(scene["domain"]["size"]) == 2
    for part in ("stress", "fragments", "reactions", "bodies"):
        if chance(r, 0.1):
            o[part] = False
    if chance(r, 0.3):
        o["probes"] = {"at": [centre], "every": r.choice([1, 3])}
    breaks = any({"fracture_energy", "toughness", "tensile_strength", "breakage"} & m.keys()
                 for m in scene.get("solid", {}).get("materials", []))
    if breaks:
        if chance(r, 0.3) and not any(p.get("breakage") is False for p in scene["stages"]):
            o["events"] = True
        if chance(r, 0.3):
            o["crack"] = {"damage": 0.1, "direction": [0, 1] if plate else [0, 1, 0], "every": r.choice([1, 4])}
        if chance(r, 0.2):
            o["modes"] = {"centre": centre, "radii": [0, 1.5], "highest": 4, "every": 3}
    if "fluid" in scene:
        if chance(r, 0.3):
            size = scene["domain"]["size"]
            o["fluid_probes"] = {"at": [[1, 1, 1]], "every": 2,
                                 "lines": [{"from": [0, 0, 0], "to": size, "points": 4}]}
        if chance(r, 0.1):
            o["permeability_every"] = 5
    return o
