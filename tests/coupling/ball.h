/* A soft ball in a periodic box of fluid that flows past it. density: of the ball, kg/m3, a string. */
#pragma once

#define BALL_IN_A_BOX(density)                                                                                         \
    "title: test\n"                                                                                                    \
    "domain: {size: [0.16, 0.16, 0.16], cells: [16, 16, 16]}\n"                                                        \
    "fluid:\n"                                                                                                         \
    "  density: 1000\n"                                                                                                \
    "  viscosity: 1.0e-3\n"                                                                                            \
    "  initial: {velocity: [0.1, 0.05, -0.02]}\n"                                                                      \
    "  sides:\n"                                                                                                       \
    "    x_low: {type: periodic}\n    x_high: {type: periodic}\n"                                                      \
    "    y_low: {type: periodic}\n    y_high: {type: periodic}\n"                                                      \
    "    z_low: {type: periodic}\n    z_high: {type: periodic}\n"                                                      \
    "solid:\n"                                                                                                         \
    "  materials:\n"                                                                                                   \
    "    - {name: soft, youngs_modulus: 1.0e6, density: " density ", fracture_energy: 0.05}\n"                         \
    "  bodies:\n"                                                                                                      \
    "    - {name: ball, material: soft, shape: sphere, centre: [0.08, 0.08, 0.08], radius: 0.04}\n"
