#!/usr/bin/env python3
"""Prints the tables of a page from measured files: a folder for each machine, as bench/run.sh fills them.
    bench/tables.py performance FOLDER...     a column for each machine, of docs/performance.md; its lines: lines.csv
    bench/tables.py growth FOLDER             times by size and traffic of one machine, of docs/scaling.md"""
import csv
import json
import math
import pathlib
import re
import sys

CHANNEL = "128x64x64"
UNIT = {"ms": " ms", "ns": " ns", "bytes": " B", "minutes": " min", "lammps": "", "cans": "", "steps": ""}


def read(paths):
    return [row for path in sorted(paths) for row in csv.DictReader(path.open(newline=""))]


def number(row, column):
    return float(row[column]) if row and row.get(column) else math.nan


class Run:
    """A whole run of the main case's S3, by its run.json and the scene beside it."""

    def __init__(self, path):
        self.record = json.loads(path.read_text())
        if self.record["status"] != "done":
            sys.exit(f"{path}: is not of a run that is done")
        scene = (path.parent / "scene.resolved.yaml").read_text()
        load = re.search(r"^coupling:(?:\n +.*)*?\n  load: (\w+)", scene, re.M)
        last = re.findall(r"^  integrator: (\w+)", scene, re.M)[-1]
        self.kind = "economical" if load and load[1] == "reaction" else last
        self.seconds = self.record["wall_seconds"]
        self.resumed_at = max(self.record.get("resumed_at_step") or 0, 0)
        self.sweeps = 1e9 * self.record["wall_seconds_by_part"]["solid"] * self.record["ranks"] / (
            self.record["ns_per_directed_bond_sweep"] * self.record["directed_bonds"])

    def stage(self, name):
        return next(span for span in self.record["timeline"] if span["span"] == name)

    def part(self, stage, part):
        return sum(self.stage(stage)[kind].get(part, 0) for kind in ("working", "waiting"))


class Machine:
    def __init__(self, folder):
        files = list(folder.glob("*-[12]*.csv"))
        self.name = folder.name
        self.rows = read(f for f in files if not f.stem.endswith("-traffic"))
        self.traffic = read(f for f in files if f.stem.endswith("-traffic"))
        self.lammps = read(folder.glob("lammps.csv"))
        self.cans = read(folder.glob("cans.csv"))
        self.runs = {run.kind: run for run in map(Run, sorted(folder.glob("*/run.json")))}
        if not self.rows:
            sys.exit(f"{folder}: holds no measured times")

    def row(self, part, size="", ranks=0, rows=None):
        """The first row of the part. Size "" and 0 ranks: any."""
        return next((row for row in (self.rows if rows is None else rows) if row["part"] == part
                     and size in ("", row["size"]) and ranks in (0, int(row["ranks"]))), None)

    def cell(self, part, size, ranks, column):
        return number(self.row(part, size, ranks), column)

    def ms(self, parts, size=CHANNEL, ranks=2):
        return sum(self.cell(part, size, ranks, "median_ms") for part in parts.split("+"))

    def parts(self, run):
        """Seconds of all parts as they were measured alone: the fluid and its forcing in every step; markers and probe
        where the solid moves, its sweeps, and contact in each sweep of fracture."""
        flow, settle, fracture = (run.stage(name)["steps"] for name in ("flow", "settle", "fracture"))
        substeps = self.cell("solid_substeps", "", 2, "units") / run.record["directed_bonds"]
        calls = {"fluid_step+forcing": flow + settle + fracture, "markers+probe": settle + fracture,
                 "interface": settle, "interface_broken": fracture, "solid_substeps": run.sweeps / substeps,
                 "contact_broken": run.sweeps - substeps * settle}
        return 1e-3 * sum(n * self.ms(part) for part, n in calls.items())

    def of_run(self, kind, run):
        if kind == "minutes":
            return run.seconds / 60
        if kind == "steps":  # over the time of its fluid's steps alone
            return run.seconds / (1e-3 * (run.record["steps"] - run.resumed_at) * self.ms("fluid_step"))
        if kind == "parts":
            return self.parts(run) / run.seconds
        if kind == "runs":  # over the Verlet run; one that was resumed is no whole one
            verlet = self.runs.get("verlet")
            return run.seconds / verlet.seconds if verlet and not run.resumed_at + verlet.resumed_at else math.nan
        if kind == "contact":
            return run.part("fracture", "contact") / run.seconds
        if kind == "output":  # files, and the samples' probe of a solid at rest
            return (run.record["wall_seconds_by_part"]["output"] + run.part("flow", "probe")) / run.seconds
        sys.exit(f"lines.csv: {kind}: no such kind")

    def ratio(self, line):
        """Seconds of the cores over those of `over`."""
        ranks, over = int(line["ranks"]), int(line["over_ranks"] or line["ranks"])
        return ranks * self.ms(line["part"], line["size"], ranks) / (
            over * self.ms(line["over"] or line["part"], line["size"], over))

    def value(self, line):
        """The number of a line of lines.csv; shares and ratios are fractions. NaN: not measured."""
        kind, part, size = line["kind"], line["part"], line["size"]
        if line["run"]:
            return self.of_run(kind, self.runs[line["run"]]) if line["run"] in self.runs else math.nan
        if kind == "ms":
            return self.ms(part, size, int(line["ranks"]))
        if kind == "ratio":
            return self.ratio(line)
        if kind == "lammps":  # LAMMPS's sweep over ours, measured with `over`
            return number(self.lammps[0] if self.lammps else None, "ratio") / (self.ratio(line) if line["over"] else 1)
        if kind == "cans":
            return number(self.row(part, size, rows=self.cans), "ratio")
        column = {"ns": "ns_per_unit", "bytes": "bytes_per_unit", "limit": "fraction_of_limit"}[kind]
        return self.cell(part, size, int(line["ranks"]), column)


def text(kind, value):
    return f"{value:.3g}{UNIT[kind]}" if kind in UNIT else f"{100 * value:.3g} %"


def is_reached(line, value):
    return bool(line["most"] and value <= float(line["most"]) or line["least"] and value >= float(line["least"]))


def entry(line, machine):
    value = machine.value(line)
    if math.isnan(value):
        return "–"
    run = machine.runs.get(line["run"]) if line["kind"] == "minutes" else None
    since = f" from step {run.resumed_at} on" if run and run.resumed_at else ""
    bold = "**" if is_reached(line, value) else ""
    return f"{bold}{text(line['kind'], value)}{since}{bold}"


def performance(machines):
    lines = read([pathlib.Path(__file__).with_name("lines.csv")])
    print(f"| what | to reach | {' | '.join(m.name for m in machines)} |\n|---|---|{'---|' * len(machines)}")
    for line in lines:
        target = line["most"] or line["least"]
        sign = "≤" if line["most"] else "≥"
        to_reach = f" {sign} {text(line['kind'], float(target))}" if target else ""
        print(f"| {line['what']} |{to_reach} | {' | '.join(entry(line, m) for m in machines)} |")
    counts = []
    for m in machines:
        values = [(line, m.value(line)) for line in lines if line["most"] or line["least"]]
        measured = [(line, value) for line, value in values if not math.isnan(value)]
        counts.append(f"{sum(is_reached(*one) for one in measured)} of {len(measured)}")
    print(f"| **targets reached** | | {' | '.join(counts)} |")


def growth_of(machine, part, title):
    print(f"| {title} | 1 rank, ms | ns a unit | 2 ranks, ms | ns a unit and core | speed-up |\n|---|---|---|---|---|---|")
    for size in dict.fromkeys(row["size"] for row in machine.rows if row["part"] == part):
        rows = [machine.row(part, size, ranks) for ranks in (1, 2)]
        cells = [(row or {}).get(column) or "–" for row in rows for column in ("median_ms", "ns_per_unit")]
        print(f"| {size} | {' | '.join(cells)} | {number(rows[0], 'median_ms') / number(rows[1], 'median_ms'):.2f} |")
    print()


def growth(machine):
    print("{cpu}, {cores} cores. {compiler}, `{flags}`; FFTW: {fftw}, plans: {plan}; {mpi}. {date}, revision {revision}.\n"
          .format(**machine.rows[0]))
    growth_of(machine, "fluid_step", "cells")
    growth_of(machine, "sweep_full", "particles")
    if machine.traffic:
        columns = "size ranks kind messages collectives bytes".split()
        print(f"| a step of | {' | '.join(columns)} |\n|{'---|' * 7}")
        for row in machine.traffic:
            print(f"| {row['part']} | {' | '.join(row[c] for c in columns)} |")
        print()


def main():
    folders = [pathlib.Path(f) for f in sys.argv[2:]]
    if sys.argv[1:2] == ["performance"] and folders:
        performance([Machine(f) for f in folders])
    elif sys.argv[1:2] == ["growth"] and len(folders) == 1:
        growth(Machine(folders[0]))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
