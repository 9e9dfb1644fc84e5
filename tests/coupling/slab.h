/* A slab between two slits of 16 cells in all, along which a body force drives the fluid; loads by probes. */
#pragma once
#include "tests/coupling/scene_of.h"

static const char *const slab = "domain: {size: [0.5, 1.5, 0.5], cells: [8, 24, 8]}\n"
                                "fluid:\n"
                                "  density: 1\n"
                                "  viscosity: 1\n"
                                "  body_force: [2, 0, 0]\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
                                "  materials: [{name: s, youngs_modulus: 1000, density: 2}]\n"
                                "  bodies: [{name: slab, shape: box, low: [-1, 0.5, -1], high: [2, 1, 2]}]\n"
                                "coupling: {load: probe}\n"
                                "output: {fields_every: 0, checkpoint_every: 0}\n";
