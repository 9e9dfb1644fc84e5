"""The tables of a run folder, and differences between two of them."""
import csv
import math

NOTHING = 1e-11  # a difference that is none, in SI: the scenes have masses, lengths and times about 1
UNSTEADY = {"momentum_residual", "angular_momentum_residual", "div_max", "volume_residual"}  # round-off themselves


def read(path):
    """Rows as words, and the unit of each column; of a table without units, no units."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    if rows and next(iter(rows[0].values())).startswith("#"):
        units = {name: unit.lstrip("#") for name, unit in rows.pop(0).items()}
        return rows, units
    return rows, {}


def table(path):
    """Rows as numbers, and the unit of each column."""
    rows, units = read(path)
    return [{name: float(value) for name, value in row.items()} for row in rows], units


def difference(one, other, units, skip=()):
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
        for name in a.keys() - UNSTEADY - set(skip):
            if math.isnan(a[name]) and math.isnan(b[name]):
                continue
            off = abs(a[name] - b[name])
            part = off / largest.get(group[name], 1) if not off < NOTHING else 0
            if not part <= worst[0]:
                worst = part, f"{name} in step {a.get('step', 0):.0f}: {a[name]} and {b[name]}"
    return worst
