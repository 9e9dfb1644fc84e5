/* Compares the solid's energy with what it was, its momentum with the impulses that it was given, and the sum of the
 * forces between particles with 0. */
#include "coupling/control/watch.h"
#include "base/files/log.h"
#include "base/par.h"
#include "base/step_status.h"
#include "coupling/control/strained.h"
#include "coupling/run.h"
#include "solid/contact/passing.h"
#include "solid/force/attachment.h"
#include "solid/imposed/walls.h"
#include "solid/measure/energy.h"

#include <math.h>

/* Parts of the exchanged energy: an imbalance of WARN is logged, and again when it is AGAIN times as large; RUIN
 * ends the run. */
static const double WARN = 0.01, AGAIN = 4, RUIN = 0.2;
/* The least energy that counts as exchanged, as a part of the largest energy: soon after a start little has been
 * exchanged. The energies' own errors are smaller than a hundredth of it. */
static const double LEAST = 1e-3;
/* RK3 takes the energy of waves near its limit within some substeps, and e_integrator has it to a tenth
 * (solid/step/rk3_loss.c): as where a heavy body suddenly drags a light one along. So many times what it has taken
 * counts as exchanged, but no more than this part of the largest energy. */
static const double INTEGRATOR = 10, INTEGRATOR_MAX = 1e-2;
/* Of the forces' size. In mixed precision they are rounded to 6e-8. */
static const double UNBALANCED = 1e-5;

static double substep_of(const struct run *r) { return r->substeps > 0 ? r->dt / r->substeps : r->dt; }

/* The part of what was exchanged from which on the log warns. RK3 integrates the work of absolute damping by its power,
 * which is off by the square of a substep; with velocity Verlet this work is known exactly. */
static double allowed(const struct run *r) {
    return WARN +
           (r->solid->stage.integrator == SOLID_RK3 ? 0.25 * r->solid->stage.damping_absolute * substep_of(r) : 0);
}

static int is_watched(const struct run *r) {
    const struct scene_stage *stage = run_stage(r);
    return r->solid && r->needs.bonds && stage->solid == SCENE_SOLID_ELASTIC && !stage->relax && !r->solid->refine;
}

enum { DAMPING, FRACTURE }; /* as in struct watch */

/* The parts, and those of WATCH_DISSIPATED; returns their sum with the integrator's. */
static double measure(struct run *r, double part[WATCH_PARTS], double taken[2], double *integrator) {
    const struct solid *s = r->solid;
    const struct solid_energy e = solid_energy_measure(r->solid);
    double share[] = {s->work_load + s->e_constraint, s->e_integrator, s->damped_missed};
    par_sum_array(share, 3);
    part[WATCH_KINETIC] = e.kinetic;
    part[WATCH_STRAIN] = e.strain;
    part[WATCH_CONTACT] = e.contact;
    taken[DAMPING] = e.damped;
    taken[FRACTURE] = e.fracture;
    part[WATCH_DISSIPATED] = e.damped + e.fracture;
    part[WATCH_WORK] = share[0];
    *integrator = share[1];
    return e.kinetic + e.strain + e.contact + part[WATCH_DISSIPATED] + share[2] + share[1] - share[0];
}

/* The sum of the forces between particles, in the direction where it is largest, over that of their sizes. After a
 * step of velocity Verlet these forces are in v_old. */
static double unbalanced(const struct run *r) {
    const struct solid *s = r->solid;
    double sum[4] = {0}, most = 0;
    if (s->stage.integrator != SOLID_VERLET || par_min(s->a_holds) == 0) return 0;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < s->dim; c++) {
            const double force = solid_density(s, h) * s->volume[h] * s->v_old[c][h];
            sum[c] += force;
            sum[3] += fabs(force);
        }
    par_sum_array(sum, 4);
    for (int c = 0; c < s->dim; c++) most = fmax(most, fabs(sum[c]));
    return sum[3] > 0 ? most / sum[3] : 0;
}

/* What a sudden load exchanges with a wave of frequency w: it swings to twice its place of rest, with 2 F^2/(m w^2). Of
 * waves that a substep resolves no better than w dt = 1 this energy is lost or found to some per cent, and whether
 * loads balance one another is not known better: 2 dt^2 sum of F^2/m, J. */
static double of_a_substep(const struct run *r) {
    const struct solid *s = r->solid;
    double sum = 0;
    for (int h = 0; h < s->n; h++) {
        const double density = solid_density(s, h);
        for (int c = 0; c < s->dim; c++) {
            const double a = fabs(s->in.body_force[c]) + fabs(s->load[c][h]) / density;
            sum += 2 * density * s->volume[h] * a * a;
        }
    }
    return par_sum(sum) * substep_of(r) * substep_of(r);
}

void watch_begin(struct run *r) {
    struct watch *w = &r->watch;
    double part[WATCH_PARTS];
    *w = (struct watch){0};
    if (!is_watched(r)) return;
    w->begun = 1;
    momentum_begin(r);
    w->first = measure(r, part, w->highest, &w->integrator_first);
    w->walls_first = par_sum(solid_walls_given(r->solid));
    if (r->needs.contact && !r->solid->contact) { /* its lists are made in the first step */
        part[WATCH_CONTACT] = solid_contact_passing_overlap(r->solid).potential;
        w->first += part[WATCH_CONTACT];
    }
    for (int k = 0; k < WATCH_PARTS; k++) w->low[k] = w->high[k] = part[k];
    w->dissipated_first = part[WATCH_DISSIPATED];
    w->substep = substep_of(r);
    w->waves_first = strained_waves(r);
}

static void take(struct run *r) {
    struct watch *w = &r->watch;
    double part[WATCH_PARTS], taken[2], integrator, largest = 0;
    w->off = measure(r, part, taken, &integrator) - w->first;
    w->dissipated = part[WATCH_DISSIPATED] - w->dissipated_first;
    w->exchanged = 0;
    for (int k = 0; k < WATCH_PARTS; k++) {
        w->low[k] = fmin(w->low[k], part[k]);
        w->high[k] = fmax(w->high[k], part[k]);
        w->exchanged = fmax(w->exchanged, w->high[k] - w->low[k]);
        largest = fmax(largest, fabs(part[k]));
    }
    w->integrator = integrator - w->integrator_first;
    w->contact = part[WATCH_CONTACT];
    if (r->solid->stage.integrator == SOLID_RK3)
        w->exchanged = fmax(w->exchanged, fmin(INTEGRATOR * fabs(w->integrator), INTEGRATOR_MAX * largest));
    w->walls = par_sum(solid_walls_given(r->solid)) - w->walls_first;
    for (int k = 0; k < 2; k++) {
        w->highest[k] = fmax(w->highest[k], taken[k]);
        w->fallen[k] = w->highest[k] - taken[k];
    }
    w->least = fmax(w->least, of_a_substep(r));
    w->exchanged = fmax(w->exchanged, fmax(LEAST * largest, w->least));
    w->unbalanced = unbalanced(r);
    w->waves = 0;
    if (fabs(w->off) > WARN * w->exchanged && substep_of(r) == w->substep && r->strained.stretch > 0)
        w->waves = strained_waves(r) - w->waves_first;
    if (fabs(w->off + w->waves) < fabs(w->off)) w->off += w->waves;
}

void watch_note(struct run *r) {
    r->watch.beyond |= r->substeps > 0 && r->dt > r->substeps * r->solid_stable;
    momentum_note(r);
}

const char *watch_cause(const struct run *r) {
    const struct watch *w = &r->watch;
    if (w->walls > fabs(w->off)) return "the walls";
    if (w->beyond || r->strained.stretch > 0) return "the integrator";
    if (w->contact > 0.1 * fabs(w->off)) return "contact";
    return r->needs.immersed ? "the coupling" : "the integrator";
}

/* Whether to log a part that is too large: the first time, and again when it has grown. */
static int must_log(double part, double least, double *logged) {
    if (!(part > least) || part <= AGAIN * *logged) return 0;
    *logged = part;
    return 1;
}

/* The force on the particles is adjoint to the velocity of the markers, so that both get the same work. */
static void warn_adjoint(struct run *r) {
    struct solid_attachment *a = r->markers.attachment;
    if (!a) return;
    double work[] = {a->work_at_markers - a->work_at_particles, a->work_size};
    a->work_at_markers = a->work_at_particles = a->work_size = 0;
    par_sum_array(work, 2);
    const double part = work[1] > 0 ? fabs(work[0]) / work[1] : 0;
    if (must_log(part, UNBALANCED, &r->watch.logged_adjoint))
        log_line("warning: step %ld: the fluid's drag does other work on the particles than on the markers that they "
                 "carry, by %.2g of it: energy is not conserved",
                 r->step, part);
}

static void warn_momentum(struct run *r) {
    struct momentum_watch *w = &r->watch.momentum;
    const double part = momentum_check(r);
    if (must_log(part, WARN, &w->logged))
        log_line(
            "warning: step %ld: the solid's momentum is off by %.3g N s, %.3g %% of the %.3g N s exchanged since the "
            "stage began: a force is missing from the balance, or the balance has one that does not act",
            r->step, w->off, 100 * part, w->exchanged);
}

/* What walls' energy is compared with: an impact at a wall may come and go between two checks, so all that moves counts
 * as exchanged. */
static double of_walls(const struct watch *w) { return fmax(w->exchanged, w->high[WATCH_KINETIC]); }

static void warn(struct run *r) {
    struct watch *w = &r->watch;
    const double part = fabs(w->off) / w->exchanged, all = of_walls(w);
    if (must_log(w->unbalanced, UNBALANCED, &w->logged_forces))
        log_line(
            "warning: step %ld: the forces between particles do not add up to 0, but to %.2g of their size: momentum "
            "is not conserved",
            r->step, w->unbalanced);
    if (must_log(w->fallen[DAMPING] / w->exchanged, WARN, &w->logged_back[DAMPING]))
        log_line(
            "warning: step %ld: damping has given back %.3g J, %.3g %% of the %.3g J exchanged since the stage began",
            r->step, w->fallen[DAMPING], 100 * w->fallen[DAMPING] / w->exchanged, w->exchanged);
    if (must_log(w->fallen[FRACTURE] / w->exchanged, WARN, &w->logged_back[FRACTURE]))
        log_line(
            "warning: step %ld: bonds that tore within a substep have done %.3g J more work than they held, %.3g %% "
            "of the %.3g J exchanged since the stage began: e_fracture is too small by it. Shorter substeps help "
            "(stages[].safety)",
            r->step, w->fallen[FRACTURE], 100 * w->fallen[FRACTURE] / w->exchanged, w->exchanged);
    if (must_log(fabs(w->walls) / all, WARN, &w->logged_walls))
        log_line("warning: step %ld: walls have given %.3g J more to the particles that they push than their potential "
                 "had, %.3g %% of %.3g J: energy is not conserved. Shorter substeps help (stages[].safety)",
                 r->step, w->walls, 100 * w->walls / all, all);
    if (must_log(part, allowed(r), &w->logged))
        log_line(
            "warning: step %ld: the solid's energy balance is off by %.3g J, %.3g %% of the %.3g J exchanged since "
            "the stage began; probably by %s. Shorter substeps show whether it is the step (stages[].safety)",
            r->step, w->off, 100 * part, w->exchanged, watch_cause(r));
}

/* Beyond its stability limit velocity Verlet creates energy in fast waves; e_integrator and the fracture energy
 * account for it, and e_integrator for what walls give. Near its limit RK3 integrates the work of absolute damping
 * wrongly by a quarter and more: there only energy that the solid has counts, not what damping is said to have taken.
 */
static double from_nothing(const struct run *r) {
    const struct watch *w = &r->watch;
    const int is_rough = r->solid->stage.integrator == SOLID_RK3 && r->solid->stage.damping_absolute > 0;
    return w->off - (is_rough ? fmax(0, w->dissipated) : 0) + (w->walls > RUIN * of_walls(w) ? w->walls : 0) +
           (w->beyond ? fmax(0, -w->integrator) + w->high[WATCH_DISSIPATED] - w->dissipated - w->dissipated_first : 0);
}

int watch_check(struct run *r, struct step_status *status) {
    struct watch *w = &r->watch;
    if (!w->begun) return 0;
    warn_momentum(r);
    warn_adjoint(r);
    take(r);
    if (!(w->exchanged > 0)) return 0;
    warn(r);
    const double made = from_nothing(r);
    if (!(made > RUIN * w->exchanged)) return 0;
    *status = (struct step_status){.failed = 1, .seen_in = STEP_STATUS_BALANCE, .field = "energy", .value = made};
    return 1;
}

void watch_report(const struct run *r) {
    const struct watch *w = &r->watch;
    if (!w->begun || !(w->exchanged > 0)) return;
    log_line(
        "stage %s: the solid's energy balance has closed to %.2g of %.3g J exchanged; its integrator has taken %.2g "
        "of them",
        run_stage(r)->name, fabs(w->off) / w->exchanged, w->exchanged, w->integrator / w->exchanged);
    const struct momentum_watch *m = &w->momentum;
    if (m->begun && m->exchanged > 0)
        log_line("stage %s: the solid's momentum has closed to %.2g of %.3g N s exchanged", run_stage(r)->name,
                 m->off / m->exchanged, m->exchanged);
}
