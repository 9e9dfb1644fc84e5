"""What must hold for any scene that runs. Each of the functions is one such rule, and gives what does not hold."""
import math
import re
import shutil
import signal
import subprocess

from . import again, tables

ROUND_OFF = 1e-6  # of the largest number of its unit in the table; creeping flows are solved to a tolerance
EARLY = 6  # steps after the first broken bond that are compared: round-off then grows a hundredfold a step
DIGITS = 1e-11  # where steps are the same but for their last digits
BALANCE = 1e-8  # of momentum and volume, which the schemes conserve to round-off
ENERGY, MOMENTUM = 0.05, 1e-6  # of what is exchanged in a stage
UNDEFINED = {"permeability", "permeability_md", "reynolds_k", "tortuosity", "dp", "porosity_effective",
             "injection_pressure", "mouth_pressure", *tables.UNSTEADY}
LISTS = ("series", "reactions", "bodies", "probes", "fluid_probes", "fragments", "events", "crack", "crack_particles",
         "modes", "intensity", "slices", "rev", "intrinsic", "solution", "growth")
MEDIUM = ("dp", "porosity_effective", "permeability", "permeability_md", "reynolds_k", "tortuosity")


def compared(one, other, names=LISTS, steps=None, skip=(), change=None):
    """The largest difference of two runs' tables, and where. change: of the first one's rows and units."""
    worst = (0, "")
    for name in names:
        a, b = one / f"{name}.csv", other / f"{name}.csv"
        if a.exists() != b.exists():
            return math.inf, f"{name}.csv is in one folder only"
        if not a.exists() or name in ("solution", "intrinsic"):  # no table of steps; solved to a tolerance
            continue
        (rows, units), (others, _) = tables.table(a), tables.table(b)
        if change:
            rows, units = change(rows, units)
        if steps is not None:
            rows, others = ([row for row in part if row.get("step", 0) <= steps] for part in (rows, others))
        part, where = tables.difference(rows, others, units, skip)
        worst = max(worst, (part, f"{name}.csv, {where}"), key=lambda found: found[0])
    return worst


def digits(one, other, names=LISTS):
    """The columns that do not have the same digits in two folders."""
    found = []
    for name in names:
        a, b = one / f"{name}.csv", other / f"{name}.csv"
        if a.exists() and b.exists():
            rows, others = tables.read(a)[0], tables.read(b)[0]
            columns = {column for x, y in zip(rows, others) for column in x if x[column] != y.get(column)}
            found += [f"{name}.csv has {len(rows)} and {len(others)} rows"] if len(rows) != len(others) else []
            found += [f"{name}.csv has other values of {', '.join(sorted(columns))}"] if columns else []
    return found


def run_again(case, what, scene, limit=ROUND_OFF, reference=None, **how):
    """Runs the scene in its other form, and compares."""
    code, told, folder = case.run(what, scene)
    if code != 0:
        return [f"{what}: ends with {code}: {told[-300:]}"]
    part, where = compared(reference or case.one, folder, steps=case.early, **how)
    return [] if part <= limit else [f"{what}: differs by {part:.2g}: {where}"]


def ranks(case):
    """But for a fragment's id, which in a refined plate depends on the number of ranks, and the angle of modes that are
    round-off themselves."""
    n = case.r.choice([2, 2, 2, 3, 4])
    code, told, folder = case.run("ranks", ranks=n)
    if code != 0:
        return [f"{n} ranks: ends with {code}: {told[-300:]}"]
    part, where = compared(case.one, folder, steps=case.early, skip=("id", "angle"))
    return [] if part <= ROUND_OFF else [f"{n} ranks differ from one by {part:.2g}: {where}"]


def resumed(case):
    """To the digit, from the first checkpoint that the run has kept."""
    kept = sorted((case.one / "checkpoint").glob("step_*.h5"))
    if not kept:
        return []
    folder = case.copy("resumed")
    for file in (folder / "checkpoint").glob("s*.h5"):
        if file.name != kept[0].name and (file.name > kept[0].name or file.name.startswith("stage")):
            file.unlink()
    (folder / "checkpoint" / "latest").write_text(kept[0].name + "\n", encoding="utf-8")
    code, told, _ = case.run("resumed", words=["--resume"])
    if code != 0:
        return [f"resumed from {kept[0].name}: ends with {code}: {told[-300:]}"]
    return [f"resumed from {kept[0].name}: {sentence}" for sentence in digits(case.one, folder)]


def resolved(case):
    """The resolved scene is a scene, and gives the same run."""
    code, told, folder = case.run("resolved", file=case.one / "scene.resolved.yaml")
    if code != 0:
        return [f"resolved: ends with {code}: {told[-300:]}"]
    return [f"resolved: {sentence}" for sentence in digits(case.one, folder)]


def drawn(case):
    code, told = case.frana("post", case.one.name)
    return [f"post: ends with {code}: {told[-300:]}"] if code != 0 else []


def units(case):
    """Lengths, masses and times in other units: powers of 4, so that numbers and their roots keep their digits."""
    if case.files or "nonlocal" in case.scene:
        return []
    scale = case.r.choice([(4.0, 1, 1), (1, 4.0, 1), (1, 1, 4.0), (2.0**-12, 2.0**-20, 2.0**-16)])
    scene = again.scaled(again.with_units(case.scene), scale, case.frana.units)

    def change(rows, of):
        by = {name: again.factor(unit, scale) for name, unit in of.items()}
        return [{name: value * by[name] for name, value in row.items()} for row in rows], of

    return run_again(case, f"units {scale}", scene, DIGITS, names=("series", "reactions", "bodies", "probes"),
                     change=change)


def given_steps(case):
    """The scene with steps that are given, and its run; or None."""
    base = again.with_steps(case.scene, case.one)
    if base is case.scene or base is None:
        return base, case.one
    code, _, folder = case.run("steps", base)
    return base if code == 0 else None, folder


def turned(case):
    """x, y, z in the places of y, z, x. Steps are given: an automatic one comes from an iteration."""
    scene = case.scene
    if len(scene.get("domain", {}).get("size", [])) != 3 or case.files or not again.can_turn(scene):
        return []
    base, reference = given_steps(case)
    if base is None:
        return []
    along = scene.get("coupling", {}).get("medium", {}).get("direction", "auto") != "auto"

    def change(rows, of):
        name = again.turned_column
        return [{name(k): v for k, v in row.items()} for row in rows], {name(k): v for k, v in of.items()}

    return run_again(case, "turned", again.turned(base), reference=reference, names=("series", "reactions", "bodies"),
                     skip=("u_bulk", *(() if along else MEDIUM)), change=change)


def moved(case):
    """By whole cells, where all sides are periodic. Steps are given, as for what is turned."""
    scene = case.scene
    if "solid" not in scene or len(scene["domain"]["size"]) != 3 or case.files or not again.can_move(scene):
        return []
    base, reference = given_steps(case)
    if base is None:
        return []
    by = [case.r.randrange(1, n // 3) for n in scene["domain"]["size"]]  # no body may be all outside
    skip = [*MEDIUM, "porosity", "specific_surface"]  # of the bodies' bounds, where these are not the period
    skip += [f"angular_momentum_{axis}" for axis in "xyz"] + ["angular_momentum_residual"]  # about the domain's centre
    return run_again(case, f"moved by {by}", again.moved(base, by), reference=reference, names=("series", "reactions"),
                     skip=skip)


def nothing(case):
    scene = again.with_nothing(case.scene) if "solid" in case.scene and "stages" in case.scene else None
    return run_again(case, "nothing", scene, DIGITS, names=("series", "bodies", "probes")) if scene else []


def cut(case):
    scene = again.cut(case.scene) if case.scene.get("output", {}).get("series_every") == 1 else None
    return run_again(case, "cut", scene, names=("series",)) if scene else []


def outputs(case):
    """Files that are written do not change a bit of the series."""
    if "stages" not in case.scene:
        return []
    code, told, folder = case.run("outputs", again.with_other_outputs(case.scene))
    if code != 0:
        return [f"outputs: ends with {code}: {told[-300:]}"]
    rows = {row["step"]: row for row in tables.read(folder / "series.csv")[0]}
    other = {name for row in tables.read(case.one / "series.csv")[0] for name in row
             if row["step"] in rows and row[name] != rows[row["step"]][name]}
    return [f"outputs change {', '.join(sorted(other))}"] if other else []


def stopped(case):
    """SIGTERM at any moment, and the same command again."""
    folder = case.folder / f"{case.name}_stopped"
    with subprocess.Popen([case.frana.program, "run", case.file.name, "--out", folder.name, "--quiet"],
                          cwd=case.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as process:
        try:
            process.wait(case.r.uniform(0.1, 1))
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGTERM)
        code = process.wait()
    if code not in (0, 75, -signal.SIGTERM, 128 + signal.SIGTERM):
        return [f"stopped: ends with {code}"]
    code, told, _ = case.run("stopped", words=["--resume-or-start"])
    if code != 0:
        return [f"stopped: goes on, and ends with {code}: {told[-300:]}"]
    part, where = compared(case.one, folder, steps=case.early)
    return [] if part <= ROUND_OFF else [f"stopped: differs by {part:.2g}: {where}"]


def largest(rows, name):
    return max((abs(row[name]) for row in rows if math.isfinite(row.get(name, math.nan))), default=0)


def closed(case):
    """The balances of each stage that the log names: of energy to the integrators' order, of momentum to round-off, as
    parts of the most that a stage has exchanged. RK3 takes a large part of little, of the shortest waves."""
    log = (case.one / "run.log").read_text(encoding="utf-8")
    number = r"([-+.\de]+)"
    lines = re.findall(rf"(stage \S+): the solid's (energy balance|momentum) has closed to {number} of {number}", log)
    most = {what: max(float(whole) for _, one, _, whole in lines if one == what) for _, what, _, _ in lines}
    conserves = case.scene.get("solid", {}).get("horizons") != "one_sided"
    limit = {"energy balance": ENERGY, "momentum": MOMENTUM if conserves else math.inf}
    return [f"{stage}: the {what} has closed to {part} of {whole}" for stage, what, part, whole in lines
            if not float(part) * float(whole) <= limit[what] * most[what]]


def balanced(case):
    """Numbers are finite, and what the schemes conserve to round-off is conserved."""
    if "stages" not in case.scene:
        return []
    rows, _ = tables.table(case.one / "series.csv")
    found = [f"{name} is {value}" for name, value in rows[-1].items()
             if math.isinf(value) or (math.isnan(value) and name not in UNDEFINED)]
    names = ["momentum_residual", "angular_momentum_residual", "div_max"]
    if case.scene.get("fluid", {}).get("diffusion") == "implicit":
        names = ["div_max"]
    found += [f"{name} is {largest(rows, name):.2g}" for name in names if largest(rows, name) > BALANCE]
    if "volume_residual" in rows[-1]:
        whole = max(largest(rows, "crack_volume"), largest(rows, "injected_volume"), 1e-6)
        if largest(rows, "volume_residual") > BALANCE * whole:
            found.append(f"volume_residual is {largest(rows, 'volume_residual'):.2g} of {whole:.2g} m3")
    return found + closed(case)


ALL = (ranks, resumed, resolved, drawn, units, turned, moved, nothing, cut, outputs, stopped)


def clean(case):
    for old in case.folder.glob(f"{case.name}[._]*"):
        shutil.rmtree(old) if old.is_dir() else old.unlink()
