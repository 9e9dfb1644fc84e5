/* Keys of the section crack_fluid. */
#include "scene/keys/table.h"

/* clang-format off */
#define OF scene_pores
static const struct scene_key pores[] = {
    KEY("permeability", NUMBER(permeability), "m2", NEEDED, FROM(0)),
    KEY("biot", NUMBER(biot), "1", NEEDED, WITHIN(0, 1)),
    KEY("modulus", NUMBER(modulus), "Pa", DEFAULT(".inf"), ABOVE(0), OR(".inf", INFINITY)),
    END};
#undef OF

#define OF scene_injection
static const struct scene_key injections[] = {
    KEY("low", VECTOR(low), "m", NEEDED),
    KEY("high", VECTOR(high), "m", NEEDED),
    KEY("rate", NUMBER(rate), "m3/s", NEEDED, NOT_WITH("pressure")),
    KEY("pressure", NUMBER(pressure), "Pa"),
    KEY("time", LIST(scene_table_pair, time.point, time.n, 1, LIST_MAX), "s, 1"),
    KEY("time_from", TEXT(time.from), "text", WITH("time")),
    END};
#undef OF
ENTRY(injection, scene_injection, injections);

#define OF scene_crack_fluid
const struct scene_key scene_table_crack_fluid[] = {
    KEY("viscosity", NUMBER(viscosity), "Pa s", NEEDED_IN(NO_FLUID), ABOVE(0)),
    /* of liquids it is small beside the crack's own compliance; gases and stiff or short cracks need it */
    KEY("compressibility", NUMBER(compressibility), "1/Pa", DEFAULT("0"), FROM(0)),
    KEY("least_pressure", NUMBER(least_pressure), "Pa", DEFAULT("0"), NEEDED_IN(FLUID)),
    KEY("least_aperture", NUMBER(least_aperture), "m", DEFAULT("auto"), ABOVE(0), OR("auto", 0)),
    KEY("leak_off", NUMBER(leak_off), "m/s^(1/2)", DEFAULT("0"), FROM(0), NOT_WITH("pores")),
    KEY("pores", SECTION(pores, pores), "section"),
    KEY("injections", LIST(injection, injection, injections, 1, LIST_MAX), "list"),
    END};
#undef OF
/* clang-format on */
