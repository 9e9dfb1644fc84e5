/* Sectors of solid angle about a particle, in the undeformed frame.  (001: sec. 3.3.7)
 *
 * In a plane, N_v = 2 consecutive of N_s = 8 sectors open 90 degrees. In 3D the sectors of the coordinate planes on
 * either side of an axis, void together, leave a cone of 45 degrees about that axis: six cones f = 0..5 for +x -x +y -y
 * +z -z.
 *
 *          \  +y  /
 *           \    /        A cone reaches 1.5 spacings, to the first shell of sites: sites behind a void one do not fill
 *       -x    h    +x     it, so that a pore one particle wide is found. The cone's rim is not part of it: on the
 *           /    \        lattice a cone contains exactly the nearest site.
 *          /  -y  \
 *
 * A cone is void if it never contained a bond, or if all its bonds are broken and their mean present length,
 * sum |X_l - X_h| / number, exceeds r_thr = delta. */
#pragma once
#include "solid/bonds/family.h"

enum { SOLID_FACES = 6, SOLID_CONE_BONDS = 4 };

/* Data of a particle that has lost bonds, for its interface test. */
struct solid_cones {
    int h;
    uint8_t bare;               /* bit f: the cone never contained a bond */
    uint8_t broken;             /* bit f: all bonds of the cone are broken */
    uint8_t isolated;           /* 1: no intact bond at all */
    uint8_t bonds[SOLID_FACES]; /* number of bonds of the broken cones, at most SOLID_CONE_BONDS each */
    int l[SOLID_FACES][SOLID_CONE_BONDS];
};

/* The cone that contains xi, or -1. spacing: of the particle. */
int solid_sector_of(const double xi[3], double spacing);
/* The direction of cone f. */
void solid_sector_axis(int f, double e[3]);
/* Edge of particle h's cube: the lattice's spacing, or volume^(1/3) for a particle on no lattice, m. */
double solid_sector_spacing(const struct solid *s, int h);

void solid_sector_classify(const struct solid *s, int h, const struct solid_family_view *view, struct solid_cones *w);
/* The same on a lattice, where a cone contains one site, the nearest one. near: offsets of these sites in the stencil;
 * intact: number of intact bonds. */
void solid_sector_classify_lattice(const struct solid *s, int h, const int near[SOLID_FACES], int intact,
                                   struct solid_cones *w);
struct solid_stencil;
void solid_sector_near(const struct solid_stencil *stencil, int near[SOLID_FACES]);
/* Bit f is set if cone f is void now. Ghosts must be current. */
unsigned solid_sector_void(const struct solid *s, const struct solid_cones *w);
