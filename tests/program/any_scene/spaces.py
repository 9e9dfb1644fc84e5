"""Scenes in space: bodies of shapes, images and points, alone and in a flow."""
from . import fluids, solids, stages
from .values import chance, number


def open_or_driven(fluid):
    """The direction of a permeability that can be measured, or what frana takes by itself."""
    for axis in "xyz":
        if fluid["sides"][axis + "_low"]["type"] in ("inflow", "outflow", "pressure"):
            return axis
    return fluid.get("driving", {}).get("direction", "auto")


def coupling(r, cells, fluid):
    c = {}
    if chance(r, 0.4):
        c["load"] = "probe"
        if chance(r, 0.4):
            c["probe_length"] = number(r, 1, 3)
        if chance(r, 0.4):
            c["forcing_iterations"] = r.choice([1, 4])
    if chance(r, 0.4):
        c["surface"] = r.choice(["shape", "cubes"])
    if chance(r, 0.3):
        c["retraction"] = number(r, 0, 0.5)
    if chance(r, 0.3):
        c["medium"] = {"low": [2, 1, 2], "high": [n - 2 for n in cells]}
    if chance(r, 0.3):
        c.setdefault("medium", {})["direction"] = open_or_driven(fluid)
    return c


def image(r, cells, name):
    """A body of voxels, and its file: a blob of two labels with holes."""
    n = [r.choice([5, 6, 8]) for _ in range(3)]
    voxels = bytearray()
    for k in range(n[2]):
        for j in range(n[1]):
            for i in range(n[0]):
                hole = chance(r, 0.06)
                voxels.append(0 if hole else 1 + (i + j > n[0]))
    low = [r.randrange(1, c - m) for c, m in zip(cells, n)]
    b = {"name": "rock", "shape": "image", "file": name, "format": "raw", "size": n, "type": "uint8", "voxel": 1,
         "low": low, "solid": [1, 2]}
    if chance(r, 0.5):
        b["floating"] = r.choice(["remove", "hold"])
    if chance(r, 0.3):
        b["axes"] = r.choice(["xzy", "zyx"])
        b["size"] = [8, 8, 8]
        voxels = (voxels * 6)[:512]
        b["low"] = [1, 1, 1]
    if chance(r, 0.3):
        b["crop"] = {"low": [0, 0, 0], "high": [b["size"][0] - 1, b["size"][1], b["size"][2]]}
    if chance(r, 0.3):
        b["flip"] = "x"
    return b, bytes(voxels)


def points(r):
    """Particles in a file: a block of a lattice, each at random by a little."""
    at = [r.randrange(1, 4) for _ in range(3)]
    rows = []
    for i in range(5):
        for j in range(5):
            for k in range(5):
                place = [a + c + 0.5 + number(r, -0.1, 0.1) for a, c in zip(at, (i, j, k))]
                rows.append(" ".join(f"{p:.4f}" for p in place) + " 1")
    return "\n".join(rows).encode()


def with_files(r, scene, cells, seed):
    """Puts a body of an image or of points in place of the first one."""
    s, files = scene["solid"], {}
    old = s["bodies"][0]
    if chance(r, 0.6):
        b, data = image(r, cells, f"scene{seed}.raw")
        files[f"scene{seed}.raw"] = data
        if len(s["materials"]) > 1 and chance(r, 0.6):
            b["materials"] = {1: "a", 2: "b"}
        else:
            b["material"] = old["material"]
    else:
        b = {"name": "rock", "shape": "points", "file": f"scene{seed}.txt", "material": old["material"]}
        files[f"scene{seed}.txt"] = points(r)
    s["bodies"] = [b]
    s.pop("interfaces", None)
    return files


def scene(r, seed):
    cells = [r.choice([10, 12, 14, 16]) for _ in range(3)]
    s = {"domain": {"size": cells}}
    has_fluid, implicit, periodic = chance(r, 0.75), False, r.choice([[chance(r, 0.3) for _ in range(3)], [True] * 3])
    if has_fluid:
        s["domain"]["cells"] = cells
        s["fluid"], periodic = fluids.fluid(r)
        implicit = "diffusion" in s["fluid"]
    s["solid"] = solids.solid(r, cells, not implicit, periodic)
    files = with_files(r, s, cells, seed) if chance(r, 0.15) else {}
    if has_fluid and chance(r, 0.6):
        s["coupling"] = coupling(r, cells, s["fluid"])
        if s["solid"]["bodies"][0]["shape"] == "image":
            s["coupling"].pop("surface", None)
    if not has_fluid:
        s["solid"]["spacing"] = 1
        s["domain"]["periodic"] = periodic
    moving = any("velocity" in b for b in s["solid"]["bodies"] + s["solid"].get("constraints", []))
    may_relax = not (has_fluid or moving or "indenters" in s["solid"])
    held = [k for k in s["solid"].get("constraints", []) if k["directions"] == "xyz"]
    may_relax = may_relax and held and len(s["solid"]["bodies"]) == 1
    s["stages"] = [stages.stage(r, k, has_fluid, implicit, has_fluid and not moving, may_relax)
                   for k in range(r.choice([1, 2, 3]))]
    stages.times_from(r, s)
    b = s["solid"]["bodies"][0]
    s["output"] = stages.output(r, s, b.get("centre", [n / 2 for n in cells]))
    return s, files


def flow(r):
    """A fluid alone, on cells that need not be cubes."""
    cells = [r.choice([8, 10, 12, 15]) for _ in range(3)]
    s = {"domain": {"size": [n * r.choice([1, 1, 0.8]) for n in cells], "cells": cells}}
    s["fluid"], _ = fluids.fluid(r)
    s["stages"] = [{"name": f"s{k}", "steps": r.choice([5, 9])} for k in range(r.choice([1, 2]))]
    for part in s["stages"]:
        if chance(r, 0.3):
            part["cfl"] = 0.5
        if "diffusion" not in s["fluid"] and chance(r, 0.3):
            part["fluid_integrator"] = "ab2"
        if chance(r, 0.2):
            part["duration"] = number(r, 0.1, 2)
    s["output"] = stages.output(r, s, None)
    s["output"].pop("probes", None)
    s["output"].pop("permeability_every", None)
    for part in ("stress", "fragments", "reactions", "bodies"):
        s["output"].pop(part, None)
    return s
