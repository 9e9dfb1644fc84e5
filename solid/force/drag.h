/* Drag of listed particles towards given velocities: the part of the fluid's load that answers to the particle's own
 * velocity. It is implicit in the velocity, so it does not limit the substep.  (docs/design/coupling.md) */
#pragma once

struct solid;

struct solid_drag {
    int n;
    const int *h;           /* [n] owned particle, each at most once */
    const double *rate;     /* [n] z, 1/s: dv/dt = ... + z (U - v) */
    double (*u)[3];         /* [n] U, m/s */
    double (*v_begin)[3];   /* [n] work: velocity at the beginning of a Verlet substep, m/s */
    double (*slip_path)[3]; /* [n] integral of v - U over the substeps since the caller set it to 0, m: the impulse that
                             * the particle has given is its mass times z times this */
};

/* Velocity Verlet, at the start of substeps: a += z (U - v). */
void solid_drag_begin(struct solid *s);
/* At the start of each Verlet substep, before v is predicted. */
void solid_drag_begin_substep(struct solid *s);
/* At the end of a Verlet substep dt, where v is v_old + dt a_old, plus what contact has added, and a has no drag: finds
 * a with the drag at the velocity v + dt/2 (a - a_old). Adds the drag's work to work_load. */
void solid_drag_end(struct solid *s, double dt, double *const a_old[3]);
/* In stage r of RK3, gamma_dt = gamma_r dt, once v has all its other changes: v <- (v + gamma_dt z U)/(1 + gamma_dt z).
 * Adds the drag's work to work_load. */
void solid_drag_stage(struct solid *s, double gamma_dt);
/* After the substeps: the reactions of held particles to the drag, by their slip paths. s->reactions must not be NULL.
 */
void solid_drag_react(struct solid *s);
