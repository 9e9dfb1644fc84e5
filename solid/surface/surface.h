/* The interface between solid and void, and what is read off the bonds there.  (001: secs 3.3.7, 3.3.9)
 *
 * What is guaranteed: on a lattice the interface is exactly the set of particles with a void site among their six
 * nearest (solid/surface/sector.h). A site is void when it never held a particle bonded to this one, or when that bond
 * is broken and the two stand further apart than r_thr = delta, centre to centre, now. A particle without any intact
 * bond is on the interface wherever it is. All of this is a function of the present state alone: a crack that closes is
 * hidden again, and an update gives what detection from scratch gives.
 *
 * Area: immersed_area = sum over the interface at the start, in the undeformed and unbroken solid, over void nearest
 * sites, of spacing^2 |n.e|, e the direction to the site, n the normal at the face between (solid/surface/area.h):
 * exact for any plane whose normals are exact, within 1 % for a sphere of five spacings or more. A particle on no
 * lattice has volume^(2/3). A_h = immersed_area / wetted faces, for all that are on the interface at the start (a
 * two-sided particle has two faces, each of area A_h); spacing^2, or volume^(2/3), for those exposed later. */
#pragma once
#include "solid/state.h"

struct solid_lost;
struct solid_watch;
struct solid_facing;
struct solid_shaped;

enum solid_faces {
    SOLID_ONE_FACE,
    SOLID_TWO_FACES, /* a wall one particle thick */
    SOLID_SET_FREE   /* a particle without any intact bond */
};

struct solid_surface {
    int n;                /* interface particles owned here, by rising local index */
    int capacity;         /* s->n: the lists below never grow */
    int *h;               /* [n] local index of the particle */
    double *normal[3];    /* [n] unit, out of the material; for two-sided particles the plate's axis, either sign */
    uint8_t *two_sided;   /* [n] enum solid_faces: nonzero where both faces are wetted */
    double *depth;        /* [n] of the particle's centre below the wetted face, m: half a spacing on a lattice */
    double *area;         /* [n] A_h, m2 (per face) */
    double initial_area;  /* A_h of the particles that were on the interface at the start */
    double immersed_area; /* whole solid, at the start, m2 */
    long total;           /* interface particles of all ranks */
    long set_free;        /* of these, without any intact bond */
    /* by owned particle, [s->n] */
    struct solid_facing *facing; /* normal as last computed, and what it was computed from */
    uint8_t *bare;               /* bit f: the nearest site in direction f was void at the start */
    double *share;               /* of immersed_area, m2; 0 off the interface */
    uint8_t *faces;              /* wetted faces at the start: 0, 1 or 2 */
    /* particles that have lost a nearest neighbour, or all their bonds */
    int watched, watch_capacity;
    struct solid_watch *watch; /* [watched] */
    int *watch_of;             /* [s->n] place in watch, or -1 */
    struct solid_lost *lost;
    int (*near)[6];              /* [bodies] on a lattice: offsets of the nearest sites */
    struct solid_shaped *shaped; /* NULL: faces are the lattice's */
};

struct solid_surface *
solid_surface_new(struct solid *s); /* Detects from scratch; sets SOLID_INTERFACE, SOLID_FIRST. Collective. */
void solid_surface_free(struct solid_surface *surface);
/* After the solid has moved or broken: looks again only where a bond has broken, and turns normals only where particles
 * have moved enough to matter. Costs next to nothing while no bond has broken. Returns 1 if the set has changed.
 * Collective. */
int solid_surface_update(struct solid *s, struct solid_surface *surface);
/* Counts only what lies in the box (X0) into immersed_area and A_h: what a wall covers is not immersed. Collective. */
void solid_surface_area_restrict(struct solid *s, struct solid_surface *surface, const double low[3],
                                 const double high[3]);
