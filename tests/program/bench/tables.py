"""The numbers of bench/tables.py by hand from a few rows and one whole run; every line of lines.csv was measured on a
machine of the repository.     usage: tables.py WORK"""
import json
import math
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, "bench")
import tables  # noqa: E402

ROWS = """part,size,ranks,median_ms,ns_per_unit,units,bytes_per_unit,fraction_of_limit
fluid_step,128x64x64,2,8,4,,504,0.5
sweep_full,54872,1,2,0.5,,,
sweep_full,54872,2,1.25,0.625,,,
sweep_full_double,54872,1,2,0.5,,,
sweep_full_mixed,54872,1,1,0.25,,,
forcing,128x64x64,2,3,,,,
probe,128x64x64,2,2,,,,
markers,128x64x64,2,1,,,,
interface,128x64x64,2,0.5,,,,
interface_broken,128x64x64,2,1.5,,,,
solid_substeps,128x64x64,2,6,,3000,,
contact_broken,128x64x64,2,0.25,,,,
"""
SCENES = {"probe": ("coupling:\n  load: probe\n", "verlet"), "reaction": ("coupling:\n  load: reaction\n", "economical"),
          "none": ("", "verlet")}


def close(value, expected):
    if not math.isclose(value, expected, rel_tol=1e-9):
        sys.exit(f"FAILED: {value} must be {expected}")


def machine_of(folder, resumed_at, load="probe"):
    """The run has 10 + 10 + 10 steps and 90 sweeps, 30 of them in settle."""
    (folder / "s3").mkdir(parents=True, exist_ok=True)
    (folder / "machine-2.csv").write_text(ROWS)
    (folder / "lammps.csv").write_text("code,ratio\nLAMMPS,28\n")
    (folder / "cans.csv").write_text("code,part,size,ranks,ratio\nCaNS,fluid_step,128x64x64,2,3.3\n")
    spans = {"flow": ({"probe": 0.02}, {"probe": 0.01}), "settle": ({}, {}), "fracture": ({"contact": 0.5}, {"contact": 0.2})}
    (folder / "s3/run.json").write_text(json.dumps({
        "status": "done", "steps": 30, "ranks": 2, "wall_seconds": 2, "resumed_at_step": resumed_at,
        "wall_seconds_by_part": {"solid": 0.9, "output": 0.05}, "directed_bonds": 1000,
        "ns_per_directed_bond_sweep": 2e4, "timeline": [
            {"span": name, "steps": 10, "working": w, "waiting": v} for name, (w, v) in spans.items()]}))
    (folder / "s3/scene.resolved.yaml").write_text(
        SCENES[load][0] + "stages:\n- name: flow\n  integrator: rk3\n- name: fracture\n  integrator: verlet\n"
        "  fluid_integrator: rk3\n")
    return tables.Machine(folder)


def value(machine, kind, part="", size="128x64x64", ranks=2, over="", over_ranks="", run=""):
    return machine.value({"kind": kind, "part": part, "size": size, "ranks": ranks, "over": over,
                          "over_ranks": over_ranks, "run": run})


work = pathlib.Path(sys.argv[1]) / "machine"
m = machine_of(work, 0)
for kind, expected in {"ms": 8, "ns": 4, "bytes": 504, "limit": 0.5, "cans": 3.3}.items():
    close(value(m, kind, "fluid_step"), expected)
close(value(m, "ratio", "sweep_full", "54872", 1, over_ranks=2), 2 / 2.5)  # a core's speed on two ranks
close(value(m, "ratio", "forcing+probe", over="fluid_step"), 5 / 8)
close(value(m, "lammps", "sweep_full", "54872", 1), 28)
close(value(m, "lammps", "sweep_full_mixed", "54872", 1, over="sweep_full_double"), 28 * 0.5 / 0.25)
parts = 30 * (8 + 3) + 20 * (1 + 2) + 10 * 0.5 + 10 * 1.5 + 90 * 6 / 3 + 60 * 0.25  # ms of 2 s
for kind, expected in {"minutes": 2 / 60, "steps": 2 / (30 * 8e-3), "runs": 1, "contact": 0.7 / 2,
                       "output": (0.05 + 0.02 + 0.01) / 2, "parts": 1e-3 * parts / 2}.items():
    close(value(m, kind, run="verlet"), expected)
assert math.isnan(value(m, "ms", "fluid_steps")) and math.isnan(value(m, "minutes", run="rk3"))
m = machine_of(work, 10)  # a run that was resumed is no whole one: its time has no ratio
assert math.isnan(value(m, "runs", run="verlet"))
close(value(m, "steps", run="verlet"), 2 / (20 * 8e-3))
for load, (_, kind) in SCENES.items():
    assert list(machine_of(work, 0, load).runs) == [kind], load
for most, least, number, expected in (("8", "", 8, 1), ("8", "", 8.01, 0), ("", "0.8", 0.8, 1), ("", "0.8", 0.79, 0),
                                      ("", "", 0, 0), ("8", "", math.nan, 0)):
    assert tables.is_reached({"most": most, "least": least}, number) == expected
machines = [tables.Machine(f) for f in pathlib.Path("bench/results").iterdir() if list(f.glob("*-1.csv"))]
for line in tables.read([pathlib.Path("bench/lines.csv")]):
    assert not (line["most"] and line["least"]), line
    assert any(not math.isnan(one.value(line)) for one in machines), f"not measured anywhere: {line}"
