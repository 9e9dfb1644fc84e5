/* Added mass: an external force -m (a.n) n per unit volume, proportional to the particle's own acceleration a along a
 * unit vector n: the pressure of the fluid displaced by an accelerating wall. Treated explicitly it is unstable for
 * short waves at any step, so it is added to the mass instead of the load. */
#pragma once

struct solid;

struct solid_added_mass {
    int n;
    const int *h;            /* [n] owned particle; repeated if it has several wetted faces */
    const double *normal[3]; /* [n] unit */
    const double *density;   /* [n] m, kg per m3 of the particle */
    double *lost;            /* [n] a.n that the face takes, m/s2; set by solid_added_mass_apply */
    double *before, *from;   /* [n] `lost`, and d.n in m, at the start of a substep of velocity Verlet */
};

/* a <- (rho I + sum m n n^T)^-1 rho a for the listed particles; adds the power of the force to s->power_load. One face
 * after another, by the Sherman-Morrison formula: exact for one face or two opposite ones. Not collective. */
void solid_added_mass_apply(struct solid *s);
/* Around the motion of a substep of velocity Verlet: work of the mean of the forces at its ends over the displacement,
 * J. leave: before the motion. arrive: after it, and after apply with the new accelerations. Not collective. */
void solid_added_mass_leave(struct solid *s);
double solid_added_mass_arrive(const struct solid *s);
