#!/usr/bin/env python3
"""Runs scenes that are put together at random, and looks at what must hold for any scene.

usage: random_scenes.py FRANA FOLDER FIRST NUMBER    the scenes of the seeds FIRST, FIRST + 1, ...; FOLDER keeps what failed

* A run ends "done", or is refused, or ends with a checkpoint (exit codes 0, 2, 3); frana check agrees with it.
* Two ranks find what one rank finds; where bonds break, in the first steps, because round-off grows a hundredfold a
  step.
* A run that goes on from its first checkpoint is the uninterrupted one, digit for digit.
* All numbers of a run that is done are finite; frana post draws it.
"""
import csv
import json
import math
import random
import shutil
import subprocess
import sys
from pathlib import Path

ROUND_OFF = 1e-5  # of the largest number of its unit in the table; creeping flows are solved to a tolerance
EARLY = 8  # steps that are compared where bonds break
NOTHING = 1e-11  # a difference that is none, in SI: the scenes have masses, lengths and times about 1
UNSTEADY = {"momentum_residual", "angular_momentum_residual", "div_max"}  # round-off themselves


def number(r, low, high):
    return round(r.uniform(low, high), 4)


def vector(r, size):
    return [number(r, -size, size) for _ in range(3)]


def fluid(r, cells):
    """The fluid, and the directions that are periodic."""
    sides, periodic = {}, [False] * 3
    for d, axis in enumerate("xyz"):
        along = ["periodic", "periodic", "slip", "wall"] + (["open", "pressure"] if d == 0 else [])
        kind = r.choice(along)
        periodic[d] = kind == "periodic"
        low, high = {"type": kind}, {"type": kind}
        if kind == "open":
            low, high = {"type": "inflow", "bulk_velocity": number(r, 0.02, 0.2)}, {"type": "outflow"}
        if kind == "pressure":
            low["pressure"] = number(r, 0, 0.1)
        if kind == "wall" and r.random() < 0.3:
            high["velocity"] = [number(r, -0.2, 0.2) if c == (d + 1) % 3 else 0 for c in range(3)]
        sides[axis + "_low"], sides[axis + "_high"] = low, high
    f = {"density": r.choice([0.5, 1]), "viscosity": r.choice([0.02, 0.1, 0.5]), "sides": sides}
    if r.random() < 0.4:
        f["initial"] = {"velocity": [number(r, -0.2, 0.2) if periodic[d] else 0 for d in range(3)]}
    if r.random() < 0.3:
        f["body_force"] = vector(r, 0.02)
    if periodic[0] and r.random() < 0.3:
        f["driving"] = {"type": r.choice(["pressure_gradient", "bulk_velocity"]), "value": number(r, 0.01, 0.1)}
    if sides["x_low"]["type"] not in ("inflow", "pressure") and r.random() < 0.2:
        f["diffusion"] = "implicit"
    elif r.random() < 0.15:
        f["projection"] = "last_stage"
    return f, periodic


def materials(r, may_break):
    found = []
    for name in "ab"[: r.choice([1, 1, 2])]:
        m = {"name": name, "youngs_modulus": r.choice([10, 100, 1000]), "density": r.choice([0.5, 1, 2, 5])}
        if may_break and r.random() < 0.6:
            m["fracture_energy"] = r.choice([1e-5, 1e-4, 1e-3, 1e-2])
        if r.random() < 0.3:
            m["horizon_ratio"] = r.choice([2, 2.5, 3.2])
        if r.random() < 0.2:
            m["poisson_ratio"] = r.choice([0.1, 0.3])
        found.append(m)
    return found


def body(r, cells, number_of, index, names):
    """Bodies stand side by side along x."""
    centre = [number(r, 0.35 * n, 0.65 * n) for n in cells]
    centre[0] = number(r, (index + 0.45) / number_of * cells[0], (index + 0.55) / number_of * cells[0])
    room = 0.33 * cells[0] / number_of
    shape = r.choice(["box", "sphere", "cylinder", "ellipsoid"])
    b = {"name": f"b{index}", "material": r.choice(names), "shape": shape}
    if shape == "box":
        half = [min(room, number(r, 1.5, 4))] + [number(r, 1.5, 0.35 * n) for n in cells[1:]]
        b["low"] = [round(c - e + 0.0031, 4) for c, e in zip(centre, half)]
        b["high"] = [round(c + e, 4) for c, e in zip(centre, half)]
    else:
        b["centre"] = centre
        if shape == "ellipsoid":
            b["radii"] = [min(room, number(r, 1.5, 4)) for _ in range(3)]
        else:
            b["radius"] = min(room, number(r, 1.5, 4))
        if shape == "cylinder":
            b["axis"], b["length"] = "z", number(r, 4, 10)
    if r.random() < 0.3:
        b["velocity"] = vector(r, 0.2)
    return b, centre


def solid(r, cells, may_break):
    s = {"materials": materials(r, may_break)}
    names = [m["name"] for m in s["materials"]]
    bodies = [body(r, cells, n, k, names) for n in [r.choice([1, 1, 2, 3])] for k in range(n)]
    s["bodies"] = [b for b, _ in bodies]
    x, y, z = bodies[0][1]
    if r.random() < 0.3:
        s["surface_correction"] = "volume"
    if may_break and r.random() < 0.3:
        at, from_ = round(x + 0.013, 4), round(y - 1.7, 4)
        s["cracks"] = [{"points": [[at, from_, -9], [at, 99, -9], [at, 99, 99], [at, from_, 99]]}]
    if r.random() < 0.3:
        k = {"low": [x - 1.2, y - 1.2, z - 1.2], "high": [x + 1.2, y + 1.2, z + 1.2]}
        k["directions"] = r.choice(["x", "yz", "xyz"])
        if r.random() < 0.3:
            k["velocity"] = [number(r, -0.02, 0.02) if c in k["directions"] else 0 for c in "xyz"]
        s["constraints"] = [k]
    if r.random() < 0.3:
        s["loads"] = [{"low": [x - 3, y - 3, z - 3], "high": [x + 3, y + 3, z + 3], "force": vector(r, 0.02)}]
        s["loads"][0]["time"] = [[0, 0], [2, 1]]
    if r.random() < 0.3:
        s["body_force"] = vector(r, 0.02)
    return s


def stage(r, index, has_fluid, implicit, may_stand):
    s = {"name": f"s{index}", "steps": r.choice([5, 8, 12, 20])}
    if may_stand and index == 0 and r.random() < 0.5:
        return {**s, "solid": "rigid"}
    if r.random() < 0.4:
        s["integrator"] = r.choice(["rk3", "verlet"])
    if r.random() < 0.2:
        s["damping_relative"] = r.choice([1, 10])
    if r.random() < 0.2:
        s["damping_absolute"] = r.choice([0.1, 0.5])
    if r.random() < 0.2:
        s["breakage"] = False
    if has_fluid and not implicit and r.random() < 0.25:
        s["fluid_integrator"] = "ab2"
    return s


def scene(seed):
    r = random.Random(seed)
    cells = [r.choice([10, 12, 14, 16]) for _ in range(3)]
    s = {"title": f"random {seed}", "domain": {"size": cells}}
    has_fluid, implicit = r.random() < 0.75, False
    if has_fluid:
        s["domain"]["cells"] = cells
        s["fluid"], _ = fluid(r, cells)
        implicit = "diffusion" in s["fluid"]
    s["solid"] = solid(r, cells, not implicit)
    if not has_fluid:
        s["solid"]["spacing"] = 1
        s["domain"]["periodic"] = [r.random() < 0.3 for _ in range(3)]
    at_rest = not any("velocity" in b for b in s["solid"]["bodies"])
    s["stages"] = [stage(r, k, has_fluid, implicit, has_fluid and at_rest) for k in range(r.choice([1, 2, 3]))]
    s["output"] = {"series_every": 1, "fields_every": r.choice([0, 10]), "checkpoint_every": r.choice([4, 7])}
    return s


class Frana:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def __call__(self, *words, ranks=1):
        launch = ["mpiexec", "-n", str(ranks)] if ranks > 1 else []
        end = subprocess.run(launch + [self.program, *words], cwd=self.folder, text=True, stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        return end.returncode, end.stdout


def table(folder):
    """Rows of series.csv as numbers, and the unit of each column."""
    with open(folder / "series.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    units = {name: unit.lstrip("#") for name, unit in rows[0].items()}
    return [{name: float(value) for name, value in row.items()} for row in rows[1:]], units


def difference(one, other, units):
    """The largest difference over the largest number of its unit, and its column."""
    if len(one) != len(other):
        return math.inf, f"{len(one)} and {len(other)} rows"
    group = {name: unit if unit != "1" else name for name, unit in units.items()}
    largest, worst = {}, (0, "")
    for row in one:
        for name, value in row.items():
            if math.isfinite(value) and name not in UNSTEADY:
                largest[group[name]] = max(largest.get(group[name], 0), abs(value))
    for a, b in zip(one, other):
        for name in a.keys() - UNSTEADY:
            if math.isnan(a[name]) and math.isnan(b[name]):
                continue
            off = abs(a[name] - b[name])
            part = off / largest[group[name]] if not off < NOTHING else 0
            if not part <= worst[0]:
                worst = part, f"{name} in step {a['step']:.0f}"
    return worst


def faults(frana, folder, seed):
    """What does not hold, as sentences."""
    name = f"scene{seed}"
    (folder / f"{name}.yaml").write_text(json.dumps(scene(seed), indent=1), encoding="utf-8")
    for old in folder.glob(f"{name}_*"):
        shutil.rmtree(old)
    checked, said = frana("check", f"{name}.yaml")
    ended, told = frana("run", f"{name}.yaml", "--out", f"{name}_1", "--quiet")
    if checked not in (0, 2) or ended not in (0, 2, 3):
        return [f"check ends with {checked}, run with {ended}: {said[-200:]} {told[-200:]}"]
    if (checked == 2) != (ended == 2):
        return [f"check ends with {checked}, run with {ended}: {(said if checked else told)[-300:]}"]
    if ended == 2:
        return []
    found = []
    both, told = frana("run", f"{name}.yaml", "--out", f"{name}_2", "--quiet", ranks=2)
    rows, units = table(folder / f"{name}_1")
    if both != ended:
        return [f"one rank ends with {ended}, two with {both}: {told[-300:]}"]
    if ended == 3:
        return []
    steps = EARLY if rows[-1].get("bonds_broken", 0) > 0 else len(rows)
    part, where = difference(rows[:steps], table(folder / f"{name}_2")[0][:steps], units)
    if not part <= ROUND_OFF:
        found.append(f"two ranks differ from one by {part:.2g}: {where}")
    found += [f"{column} is {rows[-1][column]}" for column in rows[-1] if math.isinf(rows[-1][column])]
    first = min((folder / f"{name}_1" / "checkpoint").glob("step_*.h5"))
    gone_on, told = frana("run", f"{name}.yaml", "--out", f"{name}_3", "--quiet", f"--resume={first}")
    rest = table(folder / f"{name}_3")[0] if gone_on == 0 else []
    same = [row for row in rows if rest and row["step"] >= rest[0]["step"]]
    other = {name for a, b in zip(same, rest) for name in a if repr(a[name]) != repr(b[name])}
    if other:
        found.append(f"resumed from {first.name} it has other values of {', '.join(sorted(other))}")
    if gone_on != 0:
        found.append(f"resumed from {first.name} it ends with {gone_on}: {told[-300:]}")
    drawn, told = frana("post", f"{name}_1")
    if drawn != 0:
        found.append(f"post ends with {drawn}: {told[-300:]}")
    return found


def main(program, folder, first, count):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    frana, failed = Frana(program, folder), 0
    for seed in range(int(first), int(first) + int(count)):
        found = faults(frana, folder, seed)
        for sentence in found:
            print(f"scene {seed}: {sentence}", flush=True)
        failed += bool(found)
        if not found:
            for old in folder.glob(f"scene{seed}[._]*"):
                shutil.rmtree(old) if old.is_dir() else old.unlink()
    print(f"{count} scenes, {failed} with faults")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
