#!/usr/bin/env python3
"""Runs scenes that are put together at random, and looks at what must hold for any scene.

usage: random_scenes.py FRANA FOLDER FIRST NUMBER [KIND [LOOK...]]

The scenes of the seeds FIRST, FIRST + 1, ... are of each kind in turn, or all of KIND: space, plate, cracks, flow,
element_free, nonlocal. any_scene/ puts them together. FOLDER keeps what failed. Always looked at:

* A run ends "done", or is refused, or ends with a checkpoint (exit codes 0, 2, 3); frana check agrees with it.
* Numbers are finite, and what the schemes conserve is conserved.

And for each scene two at random of these, or all that are named (any_scene/looks.py):

* ranks: several ranks find what one finds; where bonds break, in the first steps, because round-off grows.
* resumed, resolved: a run that goes on from its first checkpoint, and one of the resolved scene, are the same to the
  digit.
* units, turned, cut, nothing, outputs: so are other units, axes, stages, loads of zero and other files, but for
  round-off.
* stopped: a run that SIGTERM stops anywhere goes on as if it had not been stopped.
* drawn: frana post draws it.
"""
import json
import random
import shutil
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True

from any_scene import cracks, looks, plates, spaces

KINDS = ("space", "plate", "cracks", "space", "plate", "flow", "cracks", "space", "element_free", "nonlocal")
LOOKS = 2
PATIENCE = 300  # s; a run takes a few


def built(kind, seed):
    """The scene of a seed, and the files that it names."""
    r, files = random.Random(f"{kind} {seed}"), {}
    if kind == "space":
        scene, files = spaces.scene(r, seed)
    else:
        scene = {"flow": spaces.flow, "plate": plates.plate, "cracks": cracks.scene,
                 "element_free": plates.element_free, "nonlocal": plates.nonlocal_}[kind](r)
    return {"title": f"random {kind} {seed}", **scene}, files


class Frana:
    """The program: calls it, and knows the units of its keys."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.units = dict(line.split("\t")[:2] for line in self("keys")[1].splitlines())

    def __call__(self, *words, ranks=1):
        launch = ["mpiexec", "-n", str(ranks)] if ranks > 1 else []
        with subprocess.Popen([*launch, self.program, *words], cwd=self.folder, text=True, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
            try:
                said = process.communicate(timeout=PATIENCE)[0]
                return process.returncode, said
            except subprocess.TimeoutExpired:
                process.terminate()
                return "no end", process.communicate()[0]


class Case:
    """A scene in its folder, its run on one rank, and others of it."""

    def __init__(self, frana, kind, seed):
        self.frana, self.folder, self.name, self.r = frana, frana.folder, f"{kind}{seed}", random.Random(seed)
        self.scene, self.files = built(kind, seed)
        looks.clean(self)
        for name, data in self.files.items():
            (self.folder / name).write_bytes(data)
        self.file, self.early = self.write(self.name, self.scene), None
        self.one = self.folder / f"{self.name}_1"

    def write(self, name, scene):
        """JSON is YAML but for infinity."""
        text = json.dumps(scene, indent=1).replace("Infinity", ".inf")
        (self.folder / f"{name}.yaml").write_text(text, encoding="utf-8")
        return self.folder / f"{name}.yaml"

    def run(self, what, scene=None, ranks=1, words=(), file=None):
        """Exit code, what was said, and the run folder of this scene or of another form of it."""
        folder = self.folder / f"{self.name}_{what.split()[0]}"
        if scene:
            file = self.write(folder.name, scene)
        file = (file or self.file).relative_to(self.folder)
        return *self.frana("run", str(file), "--out", folder.name, "--quiet", *words, ranks=ranks), folder

    def copy(self, what):
        return Path(shutil.copytree(self.one, self.folder / f"{self.name}_{what}"))

    def first_break(self):
        """The step until which runs are compared, or None for all."""
        if not (self.one / "series.csv").exists():
            return None
        rows, _ = looks.tables.table(self.one / "series.csv")
        broke = [row["step"] for row in rows if row.get("bonds_broken", 0) > rows[0].get("bonds_broken", 0)]
        return broke[0] + looks.EARLY if broke else None


def faults(frana, kind, seed, named):
    """What does not hold, as sentences; and "done", "refused" or "unstable"."""
    case = Case(frana, kind, seed)
    checked, said = frana("check", case.file.name)
    ended, told, _ = case.run("1")
    if checked not in (0, 2) or ended not in (0, 2, 3) or (checked == 2) != (ended == 2):
        return [f"check ends with {checked}, run with {ended}: {(said if checked else told)[-300:]}"], "", case
    if ended != 0:
        return [], f"{'refused' if ended == 2 else 'unstable'}: {told.strip()[-300:]}", case
    case.early = case.first_break()
    chosen = [getattr(looks, name) for name in named] or case.r.sample(looks.ALL, LOOKS)
    return [sentence for look in (looks.balanced, *chosen) for sentence in look(case)], "done", case


def main(program, folder, first, count, kind=None, *named):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    frana, ends = Frana(program, folder), {}
    for seed in range(int(first), int(first) + int(count)):
        of = kind or KINDS[seed % len(KINDS)]
        found, end, case = faults(frana, of, seed, named)
        word = "faulty" if found else end.split(":")[0]
        ends[word] = ends.get(word, 0) + 1
        for sentence in found:
            print(f"{of} {seed}: {sentence}", flush=True)
        if word not in ("done", "faulty"):
            print(f"{of} {seed} is {end}", flush=True)
        if not found:
            looks.clean(case)
    print(f"{count} scenes: {', '.join(f'{n} {word}' for word, n in sorted(ends.items()))}")
    return "faulty" in ends


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
