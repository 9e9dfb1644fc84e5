/* The interface between solid and void: its particles, normals and areas.  (001: secs 3.3.7, 3.3.9)
 *
 * On a lattice the interface is exactly the set of particles with a void site among their six nearest
 * (solid/surface/sector.h). A site is void if it never held a particle bonded to this one, or if that bond is broken
 * and the present distance of the centres exceeds r_thr = delta. A particle without any intact bond is always on the
 * interface. The interface depends on the present state only: a crack that closes is no longer part of it, and an
 * update gives the same result as a detection from scratch.
 *
 * Area: immersed_area = sum over the interface at the start, in the undeformed and unbroken solid, over void nearest
 * sites, of spacing^2 |n.e|, e the direction to the site, n the normal at the face between (solid/surface/area.h):
 * exact for any plane whose normals are exact, within 1 % for a sphere of five spacings or more. A particle on no
 * lattice has volume^(2/3). A_h = immersed_area / number of wetted faces, for all particles on the interface at the
 * start (a wall one particle thick has two faces, each of area A_h); spacing^2, or volume^(2/3), for particles exposed
 * later. */
#pragma once
#include "solid/state.h"

struct solid_broken_tracker;
struct solid_cones;
struct solid_normal_data;
struct solid_exact;

enum solid_faces {
    SOLID_ONE_FACE,
    SOLID_TWO_FACES, /* a wall one particle thick */
    SOLID_ISOLATED   /* a particle without any intact bond */
};

struct solid_surface {
    int n;                /* interface particles owned here, by rising local index */
    int capacity;         /* s->n: the arrays below never grow; n once settled */
    int *h;               /* [n] local index of the particle */
    double *normal[3];    /* [n] unit, out of the material; for a wall one particle thick its axis, either sign */
    uint8_t *two_sided;   /* [n] enum solid_faces */
    double *depth;        /* [n] of the particle's centre below the wetted face, m (enum solid_depth) */
    double *curvature;    /* [n] mean curvature of the shape's surface, 1/m; NULL: of no surface */
    double *area;         /* [n] A_h, m2 (per face) */
    double initial_area;  /* A_h of the particles that were on the interface at the start */
    double immersed_area; /* whole solid, at the start, m2 */
    long total;           /* interface particles of all ranks */
    long isolated;        /* of these, without any intact bond */
    /* by owned particle, [s->n]; NULL once settled */
    struct solid_normal_data *normal_data; /* the normal, and the data that it was computed from */
    uint8_t *bare;                         /* bit f: the nearest site in direction f was void at the start */
    double *share;                         /* of immersed_area, m2; 0 off the interface */
    uint8_t *faces;                        /* number of wetted faces at the start: 0, 1 or 2 */
    float *counted; /* depth at the start by the number of neighbours, spacings; NULL: not wanted */
    /* particles that have lost a nearest neighbour, or all their bonds */
    int cones_used, cones_capacity;
    struct solid_cones *cones; /* [cones_used] */
    int *cones_of;             /* [s->n] index in cones, or -1 */
    struct solid_broken_tracker *tracker;
    int (*near)[6];            /* [bodies] on a lattice: offsets of the nearest sites */
    struct solid_exact *exact; /* NULL: the faces are the lattice's */
};

struct solid_surface *
solid_surface_new(struct solid *s); /* Detects from scratch; sets SOLID_INTERFACE, SOLID_FIRST. Collective. */
void solid_surface_free(struct solid_surface *surface);
/* Of a solid that never moves: keeps the interface's particles, and frees what only an update reads. Not collective. */
void solid_surface_freeze(struct solid_surface *surface);
/* To be called after the solid has moved or bonds have broken. Tests particles again only if a bond has broken, and
 * recomputes a normal only if its family has rotated enough. Almost free while no bond breaks. Returns 1 if the set of
 * interface particles has changed. Collective. */
int solid_surface_update(struct solid *s, struct solid_surface *surface);
/* Counts only particles in the box (X0) in immersed_area and A_h: parts covered by a wall are not immersed.
 * Collective. */
void solid_surface_area_restrict(struct solid *s, struct solid_surface *surface, const double low[3],
                                 const double high[3]);
