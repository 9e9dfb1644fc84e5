/* Drag of a flow on grains, from a single one to a packed bed. */
#pragma once

/* The largest porosity of a packed bed. */
#define PHYSICS_PACKED 0.8

/* The force of a flow on the grains in a unit of volume, N/m3: that of a packed bed below a porosity of 0.8, that of
 * single grains in a crowd above.  (Ergun 1952; Wen and Yu 1966; Schiller and Naumann 1933)
 *     porosity <= 0.8: 150 mu U (1 - e)^2/(e^3 d^2) + 1.75 rho U^2 (1 - e)/(e^3 d)
 *     above:           3/4 Cd rho U^2 (1 - e)/d e^-2.65,  Cd = 24/Re (1 + 0.15 Re^0.687), at least 0.44;
 *                    Re = rho U d/mu
 * Without gravity and with the grains at rest, both times e are the pressure drop per length. velocity: U,
 * superficial, m/s; size: d = 6 volume/surface of the grains, m; density kg/m3; viscosity: mu, Pa s. */
double physics_packed_drag(double porosity, double velocity, double size, double density, double viscosity);
