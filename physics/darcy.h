/* The unit of permeability. */
#pragma once

/* 1 D = 1 cm3/s cP cm/(cm2 atm), in m2; 1 atm = 101325 Pa */
#define PHYSICS_DARCY 9.869233e-13
