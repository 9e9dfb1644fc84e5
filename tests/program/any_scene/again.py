"""The same scene, written in another way: what it gives must be the same too."""
import copy
import re

from . import tables

AXES = "xyz"
POSITIONS = {"low", "high", "centre", "points", "about"}
BASE = {"m": (1, 0, 0), "s": (0, 0, 1), "kg": (0, 1, 0), "Pa": (-1, 1, -2), "N": (1, 1, -2), "J": (2, 1, -2),
        "W": (2, 1, -3), "Hz": (0, 0, -1), "mD": (2, 0, 0)}


def dimension(unit):
    """Powers of metre, kilogram and second, as of Pa m^(1/2) or N s/m7."""
    total, sign = [0.0, 0.0, 0.0], 1
    for part in re.split(r"( |/)", unit.replace("^(1/2)", "^0.5")):
        if part in (" ", "/", "", "1"):
            sign = -1 if part == "/" else sign
            continue
        word = re.fullmatch(r"([A-Za-z]+)\^?([\d.]*)", part)
        if word and word[1] in BASE:
            total = [t + sign * float(word[2] or 1) * b for t, b in zip(total, BASE[word[1]])]
    return total


def factor(unit, scale):
    """The number that a value of the unit is multiplied with."""
    value = 1.0
    for power, one in zip(dimension(unit), scale):
        value *= one**power
    return value


def unit_of(path, units, root):
    if path.endswith("outline") or path.endswith("spheres"):
        return "m"
    path = re.sub(r"(x|y|z)_(low|high)", "SIDE", path)
    if path == "fluid.driving.value":
        return "m/s" if root["fluid"]["driving"]["type"] == "bulk_velocity" else "Pa/m"
    return units.get(path, "1")


def with_units(scene):
    """The scene with all values of a unit that have a default in it."""
    found = copy.deepcopy(scene)
    if len(scene["domain"]["size"]) == 2:
        found["solid"].setdefault("thickness", 1)
    return found


def scaled(node, scale, units, path="", root=None):
    """The scene in units of other lengths, masses and times."""
    root = node if root is None else root
    if isinstance(node, dict) and node.get("type") == "general" and "velocity" in node:
        unit = ["1/s" if node[c] == "neumann" else "m/s" for c in "uvw"]
        return {**node, "velocity": [v * factor(one, scale) for v, one in zip(node["velocity"], unit)]}
    if isinstance(node, dict):
        return {k: scaled(v, scale, units, f"{path}.{k}".lstrip("."), root) for k, v in node.items()}
    if path.endswith(".time"):
        return [[t * scale[2], f] for t, f in node]
    if isinstance(node, list):
        return [scaled(v, scale, units, path + "[]" if isinstance(v, dict) else path, root) for v in node]
    if isinstance(node, bool) or not isinstance(node, (int, float)):
        return node
    by = factor(unit_of(path, units, root), scale)
    return node * by if by != 1 else node


def turned_word(word):
    return "".join(sorted(AXES[(AXES.index(c) + 1) % 3] for c in word))


def turned(node, key=""):
    """The scene with x, y, z in the places of y, z, x."""
    if isinstance(node, dict):
        found = {}
        for k, v in node.items():
            side = re.fullmatch(r"([xyz])_(low|high)", k)
            found[f"{turned_word(side[1])}_{side[2]}" if side else k] = turned(v, k)
        if "axis" not in found and node.get("shape") == "cylinder":
            found["axis"] = turned_word("z")
        if {"u", "v", "w"} <= node.keys():
            found["u"], found["v"], found["w"] = node["w"], node["u"], node["v"]
        return found
    if isinstance(node, list) and len(node) == 3 and not isinstance(node[0], (list, dict)):
        return [node[2], node[0], node[1]]
    if isinstance(node, list) and len(node) == 4 and key == "spheres_entry":
        return [node[2], node[0], node[1], node[3]]
    if isinstance(node, list):
        return [turned(v, "spheres_entry" if key == "spheres" else key) for v in node]
    if key in ("axis", "directions", "direction", "along") and isinstance(node, str) and set(node) <= set(AXES):
        return turned_word(node)
    if key == "axes" and node == "xy":
        return "yz"
    return node


def can_turn(scene):
    """Not where a rule has an order of its axes (vortices, rotations by axes, particles placed at random), where forces
    are single numbers of seven digits, or where a probe's tip may stand between two cells, as of a symmetric face."""
    s, bodies = scene.get("solid", {}), scene.get("solid", {}).get("bodies", [])
    return (s.get("precision") != "mixed" and "taylor_green" not in scene.get("fluid", {}).get("initial", {})
            and scene.get("coupling", {}).get("load") != "probe"
            and not any("axes" in b.get("rotation", {}) or "arrangement" in b for b in bodies))


def turned_column(name):
    """The name of a column's values in the scene that is turned."""
    end = re.fullmatch(r"(.*_)([xyz])", name)
    return end[1] + AXES[(AXES.index(end[2]) + 1) % 3] if end else name


def can_move(scene):
    """All sides are periodic, and no place must be within the domain or stands in a formula."""
    sides = scene.get("fluid", {}).get("sides", {})
    periodic = all(scene["domain"].get("periodic", [False]))
    if sides:
        periodic = all(side["type"] == "periodic" for side in sides.values())
    fixed = "initial" in scene["solid"] or "taylor_green" in scene.get("fluid", {}).get("initial", {})
    return periodic and not fixed and "medium" not in scene.get("coupling", {}) and "modes" not in scene["output"]


def moved(node, by, key=""):
    """The scene moved by whole cells along its periodic directions."""
    if isinstance(node, dict):
        return {k: moved(v, by, k) for k, v in node.items() if k not in ("fluid_probes", "probes")}
    if isinstance(node, list) and node and not isinstance(node[0], (list, dict)):
        at = POSITIONS | {"spheres"}
        return [round(v + b, 4) for v, b in zip(node, by)] + node[len(by):] if key in at else node
    if isinstance(node, list):
        return [moved(v, by, key) for v in node]
    return node


def with_steps(scene, run):
    """The scene with steps that are given. An automatic one comes from an iteration, to 1e-4: here 0.9 of it."""
    rows, _ = tables.table(run / "series.csv")
    if all("time_step" in s or ("relax" in s and "increment" in s) for s in scene["stages"]):
        return scene
    found = copy.deepcopy(scene)
    if any("until" in s or "duration" in s or "relax" in s for s in scene["stages"]):
        return None
    done = 0
    for s in found["stages"]:
        least = min((row["dt"] for row in rows if done < row["step"] <= done + s["steps"]), default=0)
        done += s["steps"]
        if not least > 0:
            return None
        s.setdefault("time_step", float(f"{0.9 * least:.4g}"))
        s.pop("cfl", None)
        s.pop("safety", None)
    return found


def cut(scene):
    """Each stage of given steps as two of half of its steps, or nothing if it has none."""
    found = copy.deepcopy(scene)
    found["stages"] = []
    for s in scene["stages"]:
        if "time_step" not in s or {"duration", "until", "relax"} & s.keys():
            found["stages"].append(s)
            continue
        first = s["steps"] // 2
        found["stages"].append({**s, "steps": first})
        found["stages"].append({**s, "name": s["name"] + "_b", "steps": s["steps"] - first})
    return found if len(found["stages"]) > len(scene["stages"]) else None


def with_nothing(scene):
    """The scene with loads, a body force, velocities and damping that are 0."""
    found = copy.deepcopy(scene)
    s = found.get("solid")
    if s is None:
        return None
    n = len(scene["domain"]["size"])
    zero, everywhere = [0] * n, {"low": [-99] * n, "high": [99] * n}
    if "refinement" in s:  # which keeps the particles of loads as they are
        return None
    s.setdefault("loads", []).append({**everywhere, "force": zero})
    s["loads"].append({**everywhere, "force": [1] * n, "time": [[0, 0]]})
    s.setdefault("body_force", zero)
    for b in s["bodies"]:
        b.setdefault("velocity", zero)
    for part in found["stages"]:
        if part.get("solid") != "rigid" and "relax" not in part:
            part.setdefault("damping_relative", 0)
    return found


def with_other_outputs(scene):
    """The scene with other files and the same checkpoints."""
    found = copy.deepcopy(scene)
    o = found["output"]
    o["fields_every"], o["log_every"], o["series_every"] = 3, 2, 1
    for part in ("probes", "crack", "modes", "events", "stress", "fragments", "intensity", "fluid_probes"):
        o.pop(part, None)
    return found
