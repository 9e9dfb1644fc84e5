/* Table of the scene's rules: unit, default, range and place of every key. */
#include "scene/rules/rule.h"
#include "base/text.h"
#include "physics/limits.h"
#include "scene/text/node.h"

#include <math.h>
#include <string.h>

#define ABOVE(x) .low = (x), .high = INFINITY, .open = 1
#define FROM(x) .low = (x), .high = INFINITY
#define WITHIN(a, b) .low = (a), .high = (b)
#define WHERE(key, list) .sibling = (key), .values = (list)
#define WITH(key) .with = (key)
#define NOT_WITH(key) .not_with = (key)
#define CHOICES(plate, space) .choices = {(plate), (space)}

enum {
    FLUID = SCENE_WITH_FLUID,
    SOLID = SCENE_WITH_SOLID,
    NO_FLUID = SCENE_WITHOUT_FLUID,
    SPACE = SCENE_IN_3D,
    PLATE = SCENE_IN_PLATE,
    STEPPED = SCENE_STEPPED,
    GALERKIN = SCENE_GALERKIN,
    ALWAYS = SCENE_ALWAYS
};
#define BOTH (FLUID | SOLID)
#define CELLS_MAX 1e6
#define PROBES_MAX 10000

#define RULE(its_path, its_unit, ...)                                                                                  \
    { .path = its_path, .unit = its_unit, ##__VA_ARGS__ }

/* clang-format off */
const struct scene_rule scene_rule_table[] = {
    RULE("title", "text"),
    RULE("domain", "section", .needed = ALWAYS, NOT_WITH("nonlocal")),
    RULE("domain.size", "m", ABOVE(0)),
    RULE("domain.cells", "1", WITHIN(1, CELLS_MAX), .needed = FLUID, .only = SPACE),
    RULE("domain.periodic", "bool", "[false, false, false]", .only = NO_FLUID),

    RULE("fluid", "section", .only = STEPPED),
    RULE("fluid.density", "kg/m3", ABOVE(0)),
    RULE("fluid.viscosity", "m2/s", ABOVE(0)),
    RULE("fluid.diffusion", "choice", "explicit"),
    RULE("fluid.initial", "section", "{}"),
    RULE("fluid.initial.velocity", "m/s", "[0, 0, 0]"),
    RULE("fluid.initial.poiseuille", "bool", "false", NOT_WITH("taylor_green")),
    RULE("fluid.initial.taylor_green", "section"),
    RULE("fluid.initial.taylor_green.velocity", "m/s"),
    RULE("fluid.initial.taylor_green.axes", "choice", "xy"),
    RULE("fluid.sides", "section"),
    RULE("fluid.sides.SIDE", "section"),
    RULE("fluid.sides.SIDE.type", "choice"),
    RULE("fluid.sides.SIDE.velocity", "m/s", "[0, 0, 0]", WHERE("type", "wall general")),
    RULE("fluid.sides.SIDE.profile", "choice", "uniform", WHERE("type", "inflow")),
    RULE("fluid.sides.SIDE.bulk_velocity", "m/s", ABOVE(0), .needed = ALWAYS, WHERE("profile", "uniform poiseuille")),
    RULE("fluid.sides.SIDE.file", "file", .needed = ALWAYS, WHERE("profile", "file")),
    RULE("fluid.sides.SIDE.pressure", "Pa", "0", WHERE("type", "pressure")),
    RULE("fluid.sides.SIDE.u", "choice", .needed = ALWAYS, WHERE("type", "general")),
    RULE("fluid.sides.SIDE.v", "choice", .needed = ALWAYS, WHERE("type", "general")),
    RULE("fluid.sides.SIDE.w", "choice", .needed = ALWAYS, WHERE("type", "general")),
    RULE("fluid.sides.SIDE.p", "choice", .needed = ALWAYS, WHERE("type", "general")),
    RULE("fluid.driving", "section", "{type: none}"),
    RULE("fluid.driving.type", "choice"),
    RULE("fluid.driving.direction", "choice", "x", WHERE("type", "pressure_gradient bulk_velocity"), NOT_WITH("along")),
    RULE("fluid.driving.along", "1", WHERE("type", "pressure_gradient")),
    RULE("fluid.driving.value", "Pa/m or m/s", .needed = ALWAYS, WHERE("type", "pressure_gradient bulk_velocity")),
    RULE("fluid.driving.frequency", "Hz", "0", FROM(0), WHERE("type", "pressure_gradient")),
    RULE("fluid.body_force", "m/s2", "[0, 0, 0]"),

    RULE("solid", "section", NOT_WITH("nonlocal")),
    RULE("solid.spacing", "m", ABOVE(0)),
    RULE("solid.model", "choice", .only = PLATE, .needed = PLATE),
    RULE("solid.method", "choice", "peridynamic", .only = PLATE),
    RULE("solid.element_free", "section", "{}", WHERE("method", "element_free")),
    RULE("solid.element_free.basis", "choice", "linear"),
    RULE("solid.element_free.weight", "choice", "cubic"),
    RULE("solid.element_free.support", "spacings", "2.5", WITHIN(1, 8)),
    RULE("solid.element_free.tip_radius", "spacings", ".inf", ABOVE(0), .word = ".inf", .load = "inf",
         WHERE("basis", "sqrt_r tip")),
    RULE("solid.element_free.tip_levels", "1", "3", WITHIN(0, 12)),
    RULE("solid.element_free.tip_patch", "spacings", "2", WITHIN(1, 20)),
    RULE("solid.element_free.cells", "1", WITHIN(1, 100000)),
    RULE("solid.element_free.gauss", "1", "4", WITHIN(1, 16)),
    RULE("solid.element_free.gauss_tip", "1", "6", WITHIN(1, 16)),
    RULE("solid.element_free.crack", "choice", "virtual"),
    RULE("solid.element_free.interface_spacing", "spacings", "1", ABOVE(0), WHERE("crack", "virtual")),
    RULE("solid.element_free.penalty", "1", "100", ABOVE(0)),
    RULE("solid.element_free.tolerance", "1", "1.0e-10", WITHIN(0, 1), .open = 3),
    RULE("solid.element_free.iterations", "1", "1000", WITHIN(1, 1000000)),
    RULE("solid.element_free.update", "choice", "conjugate"),
    RULE("solid.thickness", "m", "1", ABOVE(0), .only = PLATE),
    RULE("solid.lattice_offset", "spacings", "[0, 0, 0]", WITHIN(-1, 1)),
    RULE("solid.partial_volume", "choice", "exact", CHOICES("exact ramp ramp_cut", "exact ramp_cut"), .only = STEPPED),
    RULE("solid.horizons", "choice", "dual", .only = STEPPED),
    RULE("solid.materials", "list"),
    RULE("solid.materials[].name", "text"),
    RULE("solid.materials[].youngs_modulus", "Pa", ABOVE(0)),
    RULE("solid.materials[].density", "kg/m3", ABOVE(0)),
    RULE("solid.materials[].poisson_ratio", "1", WITHIN(-1, 0.5), .open = 3, .needed = GALERKIN),
    RULE("solid.materials[].fracture_energy", "J/m2", ".inf", ABOVE(0), .word = ".inf", .load = "inf"),
    RULE("solid.materials[].horizon_ratio", "1", "3", WITHIN(1, SCENE_HORIZON_MAX), .open = 2,
         .plate_high = SCENE_HORIZON_MAX_PLATE, .only = STEPPED),
    RULE("solid.materials[].micromodulus", "choice", "constant", .only = STEPPED),
    RULE("solid.materials[].breakage", "section", .only = STEPPED),
    RULE("solid.materials[].breakage.law", "choice"),
    RULE("solid.materials[].breakage.tensile_strength", "Pa", ABOVE(0), .needed = ALWAYS, WHERE("law", "bilinear")),
    RULE("solid.materials[].breakage.s00", "1", ABOVE(0), WHERE("law", "brittle"), WITH("alpha")),
    RULE("solid.materials[].breakage.alpha", "1", FROM(0), WHERE("law", "brittle"), WITH("s00")),
    RULE("solid.bodies", "list"),
    RULE("solid.bodies[].name", "text"),
    RULE("solid.bodies[].material", "text", NOT_WITH("materials")),
    RULE("solid.bodies[].shape", "choice", CHOICES("rectangle disc polygon points", "box sphere cylinder ellipsoid spheres points image")),
    RULE("solid.bodies[].low", "m", .needed = ALWAYS, WHERE("shape", "box image rectangle")),
    RULE("solid.bodies[].high", "m", .needed = ALWAYS, WHERE("shape", "box rectangle")),
    RULE("solid.bodies[].centre", "m", .needed = ALWAYS, WHERE("shape", "sphere cylinder ellipsoid disc")),
    RULE("solid.bodies[].radius", "m", ABOVE(0), .needed = ALWAYS, WHERE("shape", "sphere cylinder disc")),
    RULE("solid.bodies[].radii", "m", ABOVE(0), .needed = ALWAYS, WHERE("shape", "ellipsoid")),
    RULE("solid.bodies[].length", "m", ABOVE(0), .needed = ALWAYS, WHERE("shape", "cylinder")),
    RULE("solid.bodies[].axis", "choice", "z", WHERE("shape", "cylinder")),
    RULE("solid.bodies[].rotation", "section", WHERE("shape", "box cylinder ellipsoid rectangle")),
    RULE("solid.bodies[].rotation.axis", "1", .only = SPACE, .needed = SPACE, NOT_WITH("axes")),
    RULE("solid.bodies[].rotation.angle", "degrees", .needed = ALWAYS, NOT_WITH("axes")),
    RULE("solid.bodies[].rotation.axes", "1", .only = SPACE),
    RULE("solid.bodies[].rotation.about", "m"),
    RULE("solid.bodies[].outline", "list", .needed = ALWAYS, WHERE("shape", "polygon"), .bare = "at"),
    RULE("solid.bodies[].outline[].at", "m"),
    RULE("solid.bodies[].outline[].turn", "choice", "straight"),
    RULE("solid.bodies[].outline[].centre", "m", .needed = ALWAYS, WHERE("turn", "left right")),
    RULE("solid.bodies[].pieces", "list", WHERE("shape", "rectangle disc polygon box sphere cylinder ellipsoid spheres"), .only = STEPPED),
    RULE("solid.bodies[].pieces[].shape", "choice", CHOICES("rectangle disc polygon", "box sphere cylinder ellipsoid spheres")),
    RULE("solid.bodies[].pieces[].low", "m", .needed = ALWAYS, WHERE("shape", "box rectangle")),
    RULE("solid.bodies[].pieces[].high", "m", .needed = ALWAYS, WHERE("shape", "box rectangle")),
    RULE("solid.bodies[].pieces[].centre", "m", .needed = ALWAYS, WHERE("shape", "sphere cylinder ellipsoid disc")),
    RULE("solid.bodies[].pieces[].radius", "m", ABOVE(0), .needed = ALWAYS, WHERE("shape", "sphere cylinder disc")),
    RULE("solid.bodies[].pieces[].radii", "m", ABOVE(0), .needed = ALWAYS, WHERE("shape", "ellipsoid")),
    RULE("solid.bodies[].pieces[].length", "m", ABOVE(0), .needed = ALWAYS, WHERE("shape", "cylinder")),
    RULE("solid.bodies[].pieces[].axis", "choice", "z", WHERE("shape", "cylinder")),
    RULE("solid.bodies[].pieces[].rotation", "section", WHERE("shape", "box cylinder ellipsoid rectangle")),
    RULE("solid.bodies[].pieces[].rotation.axis", "1", .only = SPACE, .needed = SPACE, NOT_WITH("axes")),
    RULE("solid.bodies[].pieces[].rotation.angle", "degrees", .needed = ALWAYS, NOT_WITH("axes")),
    RULE("solid.bodies[].pieces[].rotation.axes", "1", .only = SPACE),
    RULE("solid.bodies[].pieces[].rotation.about", "m"),
    RULE("solid.bodies[].pieces[].outline", "list", .needed = ALWAYS, WHERE("shape", "polygon"), .bare = "at"),
    RULE("solid.bodies[].pieces[].outline[].at", "m"),
    RULE("solid.bodies[].pieces[].outline[].turn", "choice", "straight"),
    RULE("solid.bodies[].pieces[].outline[].centre", "m", .needed = ALWAYS, WHERE("turn", "left right")),
    RULE("solid.bodies[].pieces[].file", "file", .needed = ALWAYS, WHERE("shape", "spheres"), NOT_WITH("spheres")),
    RULE("solid.bodies[].pieces[].spheres", "m", WHERE("shape", "spheres"), NOT_WITH("file")),
    RULE("solid.bodies[].holes", "list", WHERE("shape", "rectangle disc polygon box sphere cylinder ellipsoid spheres"), .only = STEPPED),
    RULE("solid.bodies[].holes[].shape", "choice", CHOICES("rectangle disc polygon", "box sphere cylinder ellipsoid spheres")),
    RULE("solid.bodies[].holes[].low", "m", .needed = ALWAYS, WHERE("shape", "box rectangle")),
    RULE("solid.bodies[].holes[].high", "m", .needed = ALWAYS, WHERE("shape", "box rectangle")),
    RULE("solid.bodies[].holes[].centre", "m", .needed = ALWAYS, WHERE("shape", "sphere cylinder ellipsoid disc")),
    RULE("solid.bodies[].holes[].radius", "m", ABOVE(0), .needed = ALWAYS, WHERE("shape", "sphere cylinder disc")),
    RULE("solid.bodies[].holes[].radii", "m", ABOVE(0), .needed = ALWAYS, WHERE("shape", "ellipsoid")),
    RULE("solid.bodies[].holes[].length", "m", ABOVE(0), .needed = ALWAYS, WHERE("shape", "cylinder")),
    RULE("solid.bodies[].holes[].axis", "choice", "z", WHERE("shape", "cylinder")),
    RULE("solid.bodies[].holes[].rotation", "section", WHERE("shape", "box cylinder ellipsoid rectangle")),
    RULE("solid.bodies[].holes[].rotation.axis", "1", .only = SPACE, .needed = SPACE, NOT_WITH("axes")),
    RULE("solid.bodies[].holes[].rotation.angle", "degrees", .needed = ALWAYS, NOT_WITH("axes")),
    RULE("solid.bodies[].holes[].rotation.axes", "1", .only = SPACE),
    RULE("solid.bodies[].holes[].rotation.about", "m"),
    RULE("solid.bodies[].holes[].outline", "list", .needed = ALWAYS, WHERE("shape", "polygon"), .bare = "at"),
    RULE("solid.bodies[].holes[].outline[].at", "m"),
    RULE("solid.bodies[].holes[].outline[].turn", "choice", "straight"),
    RULE("solid.bodies[].holes[].outline[].centre", "m", .needed = ALWAYS, WHERE("turn", "left right")),
    RULE("solid.bodies[].holes[].file", "file", .needed = ALWAYS, WHERE("shape", "spheres"), NOT_WITH("spheres")),
    RULE("solid.bodies[].holes[].spheres", "m", WHERE("shape", "spheres"), NOT_WITH("file")),
    RULE("solid.bodies[].file", "file", .needed = ALWAYS, WHERE("shape", "points spheres image"), NOT_WITH("spheres")),
    RULE("solid.bodies[].spheres", "m", WHERE("shape", "spheres"), NOT_WITH("file")),
    RULE("solid.bodies[].contacts", "choice", "bonded", WHERE("shape", "box sphere cylinder ellipsoid spheres")),
    RULE("solid.bodies[].velocity", "m/s", "[0, 0, 0]", .only = STEPPED),
    RULE("solid.bodies[].cavities", "section", WHERE("shape", "box sphere cylinder ellipsoid spheres")),
    RULE("solid.bodies[].cavities.period", "m", ABOVE(0)),
    RULE("solid.bodies[].cavities.radius", "m", ABOVE(0)),
    RULE("solid.bodies[].cavities.centre", "m"),
    RULE("solid.bodies[].arrangement", "section", WHERE("shape", "rectangle disc polygon points box sphere cylinder ellipsoid spheres")),
    RULE("solid.bodies[].arrangement.kind", "choice", "lattice"),
    RULE("solid.bodies[].arrangement.perturbation", "spacings", WITHIN(0, 0.4), .open = 1, .needed = ALWAYS, WHERE("kind", "perturbed")),
    RULE("solid.bodies[].arrangement.seed", "1", "1", FROM(0), WHERE("kind", "perturbed centroidal random")),
    RULE("solid.bodies[].arrangement.volume", "choice", "equal", WHERE("kind", "hexagonal centroidal random")),
    RULE("solid.bodies[].format", "choice", "auto", WHERE("shape", "image")),
    RULE("solid.bodies[].dataset", "text", WHERE("format", "auto hdf5")),
    RULE("solid.bodies[].size", "voxels", WITHIN(1, CELLS_MAX), WHERE("shape", "image")),
    RULE("solid.bodies[].type", "choice", "header", WHERE("shape", "image")),
    RULE("solid.bodies[].byte_order", "choice", "header", WHERE("shape", "image")),
    RULE("solid.bodies[].axes", "choice", "xyz", WHERE("shape", "image")),
    RULE("solid.bodies[].header_bytes", "bytes", FROM(0), WHERE("format", "auto raw")),
    RULE("solid.bodies[].voxel", "m", ABOVE(0), .needed = ALWAYS, WHERE("shape", "image")),
    RULE("solid.bodies[].crop", "section", WHERE("shape", "image")),
    RULE("solid.bodies[].crop.low", "voxels", WITHIN(0, CELLS_MAX)),
    RULE("solid.bodies[].crop.high", "voxels", WITHIN(1, CELLS_MAX)),
    RULE("solid.bodies[].solid", "list", .needed = ALWAYS, WHERE("shape", "image"), NOT_WITH("threshold")),
    RULE("solid.bodies[].materials", "list", WHERE("shape", "image"), NOT_WITH("threshold"), .named = {"label", "material"}),
    RULE("solid.bodies[].materials[].label", "1"),
    RULE("solid.bodies[].materials[].material", "text"),
    RULE("solid.bodies[].threshold", "1", WHERE("shape", "image")),
    RULE("solid.bodies[].flip", "text", WHERE("shape", "image")),
    RULE("solid.bodies[].mirror", "text", WHERE("shape", "image")),
    RULE("solid.bodies[].floating", "choice", "keep", WHERE("shape", "image")),
    RULE("solid.interfaces", "list"),
    RULE("solid.interfaces[].between", "text"),
    RULE("solid.interfaces[].fracture_energy", "J/m2", ABOVE(0), .word = ".inf", .load = "inf"),
    RULE("solid.cracks", "list"),
    RULE("solid.cracks[].name", "text"),
    RULE("solid.cracks[].points", "m"),
    RULE("solid.constraints", "list"),
    RULE("solid.constraints[].low", "m"),
    RULE("solid.constraints[].high", "m"),
    RULE("solid.constraints[].rotation", "section"),
    RULE("solid.constraints[].rotation.axis", "1", .only = SPACE, .needed = SPACE, NOT_WITH("axes")),
    RULE("solid.constraints[].rotation.angle", "degrees", .needed = ALWAYS, NOT_WITH("axes")),
    RULE("solid.constraints[].rotation.axes", "1", .only = SPACE),
    RULE("solid.constraints[].rotation.about", "m"),
    RULE("solid.constraints[].directions", "text", "xyz", .in_plate = "xy"),
    RULE("solid.constraints[].velocity", "m/s", "[0, 0, 0]", NOT_WITH("displacement"), .only = STEPPED),
    RULE("solid.constraints[].displacement", "m"),
    RULE("solid.constraints[].time", "s, 1", .only = STEPPED),
    RULE("solid.unbreakable", "list", .only = STEPPED),
    RULE("solid.unbreakable[].low", "m"),
    RULE("solid.unbreakable[].high", "m"),
    RULE("solid.unbreakable[].rotation", "section"),
    RULE("solid.unbreakable[].rotation.axis", "1", .only = SPACE, .needed = SPACE, NOT_WITH("axes")),
    RULE("solid.unbreakable[].rotation.angle", "degrees", .needed = ALWAYS, NOT_WITH("axes")),
    RULE("solid.unbreakable[].rotation.axes", "1", .only = SPACE),
    RULE("solid.unbreakable[].rotation.about", "m"),
    RULE("solid.loads", "list"),
    RULE("solid.loads[].low", "m", .needed = ALWAYS, NOT_WITH("edge"), .only = STEPPED),
    RULE("solid.loads[].high", "m", .needed = ALWAYS, NOT_WITH("edge"), .only = STEPPED),
    RULE("solid.loads[].rotation", "section", NOT_WITH("edge")),
    RULE("solid.loads[].rotation.axis", "1", .only = SPACE, .needed = SPACE, NOT_WITH("axes")),
    RULE("solid.loads[].rotation.angle", "degrees", .needed = ALWAYS, NOT_WITH("axes")),
    RULE("solid.loads[].rotation.axes", "1", .only = SPACE),
    RULE("solid.loads[].rotation.about", "m"),
    RULE("solid.loads[].force", "N/m3", .needed = ALWAYS, NOT_WITH("edge"), .only = STEPPED),
    RULE("solid.loads[].edge", "section", .only = PLATE, .needed = GALERKIN),
    RULE("solid.loads[].edge.from", "m"),
    RULE("solid.loads[].edge.to", "m"),
    RULE("solid.loads[].traction", "Pa", .needed = ALWAYS, WITH("edge")),
    RULE("solid.loads[].depth", "choice", "layer", WITH("edge"), .only = STEPPED),
    RULE("solid.loads[].time", "s, 1", .only = STEPPED),
    RULE("solid.initial", "list", .only = STEPPED),
    RULE("solid.initial[].shape", "choice"),
    RULE("solid.initial[].along", "choice", CHOICES("x y", "x y z")),
    RULE("solid.initial[].centre", "m"),
    RULE("solid.initial[].width", "m", ABOVE(0)),
    RULE("solid.initial[].displacement", "m"),
    RULE("solid.indenters", "list", .only = STEPPED),
    RULE("solid.indenters[].shape", "choice"),
    RULE("solid.indenters[].centre", "m"),
    RULE("solid.indenters[].radius", "m", ABOVE(0)),
    RULE("solid.indenters[].velocity", "m/s", "[0, 0, 0]"),
    RULE("solid.indenters[].stiffness", "N/m5", ABOVE(0)),
    RULE("solid.refinement", "section", .only = PLATE | STEPPED),
    RULE("solid.refinement.levels", "1", "1", WITHIN(1, PHYSICS_LEVELS_MAX)),
    RULE("solid.refinement.energy", "1", "0.4", WITHIN(0, 1), .open = 1, .word = "off", .load = "0"),
    RULE("solid.refinement.damage", "1", "off", WITHIN(0, 1), .open = 3, .word = "off", .load = "0"),
    RULE("solid.refinement.from", "s", "0", FROM(0)),
    RULE("solid.refinement.low", "m", WITH("high")),
    RULE("solid.refinement.high", "m", WITH("low")),
    RULE("solid.refinement.rotation", "section", WITH("low")),
    RULE("solid.refinement.rotation.angle", "degrees"),
    RULE("solid.refinement.rotation.about", "m"),
    RULE("solid.refinement.every", "steps", "10", FROM(1)),
    RULE("solid.refinement.horizon", "choice", "scaled"),
    RULE("solid.refinement.interface", "choice", "plain"),
    RULE("solid.refinement.held", "choice", "keep"),
    RULE("solid.refinement.start", "list"),
    RULE("solid.refinement.start[].low", "m"),
    RULE("solid.refinement.start[].high", "m"),
    RULE("solid.refinement.start[].rotation", "section"),
    RULE("solid.refinement.start[].rotation.angle", "degrees"),
    RULE("solid.refinement.start[].rotation.about", "m"),
    RULE("solid.refinement.start[].level", "1", WITHIN(1, PHYSICS_LEVELS_MAX)),
    RULE("solid.surface_correction", "choice", "energy", .only = STEPPED),
    RULE("solid.body_force", "m/s2", "[0, 0, 0]"),
    RULE("solid.contact", "section", "{}", .only = STEPPED),
    RULE("solid.contact.enabled", "bool", "true"),
    RULE("solid.contact.stiffness", "1", "15", ABOVE(0)), /* k_c/c0: 15 is from the EMU Theory Manual */
    RULE("solid.contact.exponent", "1", "1", ABOVE(0)),
    RULE("solid.contact.radius", "1", "1", ABOVE(0)),

    RULE("coupling", "section", "{}", .only = BOTH),
    RULE("coupling.forcing_iterations", "1", "2", WITHIN(1, 100)),
    RULE("coupling.surface", "choice", "lattice"),
    RULE("coupling.retraction", "cells", WITHIN(-1, 1)),
    RULE("coupling.probe_length", "cells", "2", WITHIN(0, 10), .open = 1),
    RULE("coupling.load", "choice"),
    RULE("coupling.scheme", "choice", "explicit"),
    RULE("coupling.relaxation", "choice", "quasi_newton", WHERE("scheme", "strong")),
    RULE("coupling.tolerance", "1", "1.0e-3", WITHIN(0, 1), .open = 1, WHERE("scheme", "strong")),
    RULE("coupling.iterations", "1", "50", WITHIN(1, 1000), WHERE("scheme", "strong")),
    RULE("coupling.medium", "section"),
    RULE("coupling.medium.low", "m"),
    RULE("coupling.medium.high", "m"),
    RULE("coupling.medium.direction", "choice", "auto"),

    RULE("nonlocal", "section"),
    RULE("nonlocal.dimension", "1", WITHIN(1, 3)),
    RULE("nonlocal.exponent", "1", WITHIN(0, 2)),
    RULE("nonlocal.horizon", "m", ABOVE(0)),
    RULE("nonlocal.inner_radius", "m", ABOVE(0)),
    RULE("nonlocal.outer_radius", "m", ABOVE(0)),
    RULE("nonlocal.spacing", "m", ABOVE(0), .needed = ALWAYS, NOT_WITH("points")),
    RULE("nonlocal.points", "1", FROM(2)),
    RULE("nonlocal.arrangement", "section", "{}"),
    RULE("nonlocal.arrangement.kind", "choice", "lattice"),
    RULE("nonlocal.arrangement.perturbation", "spacings", WITHIN(0, 0.4), .open = 1, .needed = ALWAYS, WHERE("kind", "perturbed")),
    RULE("nonlocal.arrangement.seed", "1", "1", FROM(0), WHERE("kind", "perturbed centroidal random")),
    RULE("nonlocal.arrangement.volume", "choice", "equal"),
    RULE("nonlocal.condition", "bool", "true"),

    RULE("stages", "list", .only = STEPPED, .needed = ALWAYS),
    RULE("stages[].name", "text"),
    RULE("stages[].steps", "1", FROM(0)),
    RULE("stages[].until", "section", .only = BOTH),
    RULE("stages[].until.quantity", "choice", "permeability"),
    RULE("stages[].until.change", "1", "1.0e-4", WITHIN(0, 1), .open = 1),
    RULE("stages[].until.window", "steps", "20", FROM(2)),
    RULE("stages[].time_step", "s", "auto", ABOVE(0), .word = "auto", .load = "0"),
    RULE("stages[].cfl", "1", "0.9", WITHIN(0, 1), .open = 1),
    RULE("stages[].solid", "choice", "elastic", .only = SOLID),
    RULE("stages[].relax", "bool", "false", .only = SOLID | NO_FLUID),
    RULE("stages[].increment", "s", ABOVE(0), .only = SOLID | NO_FLUID),
    RULE("stages[].tolerance", "1", "1.0e-6", WITHIN(0, 0.1), .open = 1, .only = SOLID | NO_FLUID),
    RULE("stages[].integrator", "choice", "rk3", .only = SOLID),
    RULE("stages[].substeps", "1", "auto", WITHIN(1, 1e6), .word = "auto", .load = "0", .only = SOLID),
    RULE("stages[].safety", "1", "0.95", WITHIN(0, 1), .open = 1, .only = SOLID),
    RULE("stages[].breakage", "bool", "true", .only = SOLID),
    RULE("stages[].damping_relative", "N s/m7", "0", FROM(0), .only = SOLID),
    RULE("stages[].damping_absolute", "1/s", "0", FROM(0), .only = SOLID),

    RULE("output", "section", "{}"),
    RULE("output.series_every", "steps", "10", FROM(0), .only = STEPPED),
    RULE("output.fields_every", "steps", "auto", FROM(0), .word = "auto", .load = "-1"),
    RULE("output.checkpoint_every", "steps", "1000", FROM(0), .only = STEPPED),
    RULE("output.log_every", "steps", "100", FROM(0), .only = STEPPED),
    RULE("output.stress", "bool", "true", .only = STEPPED),
    RULE("output.fragments", "bool", "true", .only = SOLID | STEPPED),
    RULE("output.reactions", "bool", "true", .only = SOLID | STEPPED),
    RULE("output.bodies", "bool", "true", .only = SOLID | STEPPED),
    RULE("output.crack", "section", .only = SOLID | STEPPED),
    RULE("output.crack.damage", "1", "0.35", WITHIN(0, 1), .open = 3),
    RULE("output.crack.direction", "1", "[1, 0, 0]"),
    RULE("output.crack.window", "s", "2e-6", ABOVE(0)),
    RULE("output.crack.every", "steps", "10", FROM(1)),
    RULE("output.intensity", "section", .only = SOLID | PLATE),
    RULE("output.intensity.radii", "m", ABOVE(0)),
    RULE("output.intensity.crack", "1", "all", FROM(0), .word = "all", .load = "-1", .only = SOLID | STEPPED),
    RULE("output.intensity.tip", "1", "all", WITHIN(0, 1), .word = "all", .load = "-1", .only = SOLID | STEPPED),
    RULE("output.intensity.every", "steps", "10", FROM(1), .only = SOLID | STEPPED),
    RULE("output.probes", "section", .only = SOLID | STEPPED),
    RULE("output.probes.at", "m"),
    RULE("output.probes.every", "steps", "10", FROM(1)),
    RULE("output.fluid_probes", "section", .only = FLUID),
    RULE("output.fluid_probes.at", "m"),
    RULE("output.fluid_probes.lines", "list"),
    RULE("output.fluid_probes.lines[].from", "m"),
    RULE("output.fluid_probes.lines[].to", "m"),
    RULE("output.fluid_probes.lines[].points", "1", WITHIN(2, PROBES_MAX)),
    RULE("output.fluid_probes.every", "steps", "10", FROM(1)),
    {.path = NULL}};
/* clang-format on */

/* Whether the path matches the pattern: [] matches [3], SIDE matches a word. */
static int matches(const char *pattern, const char *path) {
    while (*pattern) {
        if (*pattern == 'S' && !strncmp(pattern, "SIDE", 4)) {
            pattern += 4;
            path += strcspn(path, ".[");
        } else if (*pattern == '[') {
            if (*path != '[') return 0;
            pattern += 2;
            path += strcspn(path, "]") + 1;
        } else if (*pattern++ != *path++) {
            return 0;
        }
    }
    return !*path;
}

const struct scene_rule *scene_rule_find(const char *path) {
    for (const struct scene_rule *rule = scene_rule_table; rule->path; rule++)
        if (matches(rule->path, path)) return rule;
    return NULL;
}

char *scene_rule_range(const struct scene_rule *rule) {
    if (rule->low == rule->high) return NULL;
    const char *below = rule->open & 2 ? "less than" : "at most", *above = rule->open & 1 ? "greater than" : "at least";
    if (isinf(rule->high)) return text_new("%s %.15g", above, rule->low);
    if (!rule->open) return text_new("between %.15g and %.15g", rule->low, rule->high);
    return text_new("%s %.15g and %s %.15g", above, rule->low, below, rule->high);
}

int scene_rule_admits(const struct scene_rule *rule, double value) {
    if (rule->low == rule->high) return 1;
    if (value < rule->low || (rule->open & 1 && value == rule->low)) return 0;
    return value <= rule->high && !(rule->open & 2 && value == rule->high);
}

char *scene_rule_in_units(const struct scene_rule *rule) {
    static const char *const none[] = {"1", "text", "bool", "choice", "section", "list", "file"};
    for (size_t i = 0; rule && i < sizeof none / sizeof *none; i++)
        if (!strcmp(rule->unit, none[i])) rule = NULL;
    return rule ? text_new(" (%s)", rule->unit) : text_new("%s", "");
}
