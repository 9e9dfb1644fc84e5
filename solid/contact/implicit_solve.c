/* Solves for the motion under contact, by Chebyshev's or Nesterov's iteration. */
#include "base/par.h"
#include "base/par_ghost.h"
#include "base/vec.h"
#include "physics/chebyshev.h"
#include "solid/contact/ends.h"
#include "solid/contact/implicit_parts.h"

#include <math.h>
#include <string.h>

/* The residual over the largest acceleration of contact, at which the iteration ends; the energy of contact is kept to
 * this part of its work in a substep. Momentum is kept to round-off in any case. */
static const double TOLERANCE = 1e-6;
/* Accelerations are sums of multiples of contact's quantum, so the residual cannot fall below some of them. */
enum { QUANTA = 16, ITERATIONS_MAX = 2000 };
/* Chebyshev's iteration has failed if it takes more iterations. */
enum { FEW = 60 };
/* Most iterations between two reductions of the residual over the ranks; the iteration after which pairs that touch
 * only since contact has moved them are looked for, besides those of reductions. */
enum { LOOK = 16, EARLY = 2 };
/* The least width of the range in which the eigenvalues are taken to be. */
static const double LEAST_BETA = 2e-3;

/* The added mass as part of the nodes' mass, as in solid_added_mass_apply. */
static void carry(struct solid_contact_implicit *m) {
    for (int k = 0; k < m->faces; k++) {
        struct solid_contact_face *f = &m->face[k];
        double *push = m->by.push[f->node], along = 0;
        for (int c = 0; c < 3; c++) along += push[c] * f->normal[c];
        f->lost = f->share * along;
        for (int c = 0; c < 3; c++) push[c] -= f->lost * f->normal[c];
    }
}

/* Adds to push, which is 0, the accelerations by contact if the nodes end at `now`. */
static void push(struct solid_contact_implicit *m) {
    solid_contact_touching_push(&m->touching, &m->law, (const double(*)[4])m->by.now, m->by.push);
    carry(m);
}

/* Asks the owners where the ends of other ranks are. Collective. */
static void update_served(struct solid *s, struct solid_contact *c) {
    struct solid_contact_implicit *m = c->implicit;
    if (!m->across) return;
    for (int k = 0; k < m->nodes; k++)
        for (int i = 0; m->node[k].is_own && i < s->dim; i++) s->d[i][m->node[k].particle] = m->by.now[k][i];
    if (c->reaches_ghosts) par_ghost_update(s->ghost, s->dim, s->d, s->n);
    if (c->ghosts.active) solid_contact_ghosts_update(s, &c->ghosts);
    for (int k = 0; k < m->remote_ends; k++) {
        const int end = m->remote[k], particle = c->ends->particle[end], is_served = particle < 0,
                  at = is_served ? SOLID_CONTACT_SERVED_END - particle : particle;
        for (int i = 0; i < s->dim; i++) m->motion[end].now[i] = (is_served ? c->ghosts.d[i] : s->d[i])[at];
        if (m->node_of[end] > 0) memcpy(m->by.now[m->node_of[end] - 1], m->motion[end].now, sizeof *m->by.now);
    }
}

enum { RESIDUAL, LARGEST, STIFFEST, ACROSS, SEEN };

/* The largest component of the residual and of the acceleration, m/s2, and the rest, over all ranks. Collective. */
static void measure(const struct solid_contact_implicit *m, double seen[SEEN]) {
    const struct solid_contact_iterate *by = &m->by;
    vec residual = vec_set(0), largest = vec_set(0), lost = vec_set(0); /* lost: 0, or NaN if a value is not finite */
    for (int n = 0; n < 4 * m->nodes; n += VEC_LANES) {
        const vec moves = vec_load((double *)by->moves + n), push = moves * vec_load((double *)by->push + n),
                  off = push - moves * vec_load((double *)by->a + n);
        residual = vec_absmax(residual, off);
        largest = vec_absmax(largest, push);
        lost += off - off;
    }
    seen[RESIDUAL] = vec_highest(residual) + vec_sum(lost);
    seen[LARGEST] = vec_highest(largest);
    seen[STIFFEST] = m->stiffest;
    seen[ACROSS] = m->across;
    par_max_array(seen, SEEN);
}

/* The next acceleration of the nodes, of their numbers from n on, and where they end with it; push is 0 again. */
static inline void put(struct solid_contact_iterate by, int n, vec a, double half) {
    vec_store((double *)by.a + n, a);
    vec_store((double *)by.now + n, vec_load((double *)by.predicted + n) + half * vec_load((double *)by.moves + n) * a);
    vec_store((double *)by.push + n, vec_set(0));
}

/* How the iterates go on: by Chebyshev's iteration; or by Nesterov's, which takes more iterations but also converges
 * where pairs touch in one iterate and not in the next. */
struct pace {
    struct physics_chebyshev term;
    int is_careful;
};

/* beta: the eigenvalues are between 1 and 1 + beta. */
static struct pace pace_of(double beta, int is_careful) {
    struct pace p = {.term = physics_chebyshev_of(1, 1 + fmax(beta, LEAST_BETA)), .is_careful = is_careful};
    if (!is_careful) return p;
    p.term.gain = 1 / (1 + beta);
    p.term.keep = (sqrt(1 + beta) - 1) / (sqrt(1 + beta) + 1);
    return p;
}

/* One iteration. Careful: turn <- keep turn + gain r, a <- a + gain r + keep turn with the residual r. */
static void improve(struct solid_contact_implicit *m, const struct pace *pace, double half) {
    const double keep = pace->term.keep, gain = pace->term.gain, ahead = pace->is_careful ? keep : 1,
                 once = pace->is_careful ? gain : 0;
    const struct solid_contact_iterate by = m->by; /* a copy, which no store changes */
    for (int n = 0, end = 4 * m->nodes; n < end; n += VEC_LANES) {
        const vec a = vec_load((double *)by.a + n), residual = vec_load((double *)by.push + n) - a,
                  turn = keep * vec_load((double *)by.turn + n) + gain * residual;
        vec_store((double *)by.turn + n, turn);
        put(by, n, a + ahead * turn + once * residual, half);
    }
}

/* Takes the speed out of the iteration, which else swings about its end. */
static void stop(struct solid_contact_implicit *m) {
    for (int k = 0; k < m->nodes; k++) memset(m->by.turn[k], 0, sizeof m->by.turn[k]);
}

/* Starts again without contact. */
static void start_again(struct solid_contact_implicit *m) {
    stop(m);
    for (int n = 0; n < 4 * m->nodes; n += VEC_LANES) put(m->by, n, vec_set(0), 0);
}

/* Gives the nodes the accelerations by the last iterate: those of a pair are opposite to round-off. */
static void settle(struct solid_contact_implicit *m, double half) {
    for (int n = 0; n < 4 * m->nodes; n += VEC_LANES) put(m->by, n, vec_load((double *)m->by.push + n), half);
}

/* The step has failed: it is made again with shorter substeps, or the run ends. */
static void fail(const struct solid *s, struct solid_contact_implicit *m, const double seen[SEEN]) {
    int worst = -1;
    double most = -1;
    for (int k = 0; k < m->nodes; k++)
        for (int i = 0; i < s->dim; i++) {
            const double residual = fabs(m->by.push[k][i] - m->by.a[k][i]) * m->by.moves[k][i];
            if (residual <= most) continue;
            most = residual;
            worst = k;
        }
    if (worst < 0 || m->status.failed) return;
    m->status = (struct step_status){.failed = 1,
                                     .seen_in = STEP_STATUS_SOLID,
                                     .rank = par_rank(),
                                     .field = "contact's error",
                                     .value = most / seen[LARGEST]};
    const int particle = m->node[worst].particle;
    for (int i = 0; i < s->dim && particle >= 0; i++) m->status.x[i] = s->x0[i][particle];
}

int solid_contact_implicit_solve_crosses(const struct solid_contact *c) {
    return c->reaches_ghosts || c->ghosts.active;
}

/* Iterations until the residual, now `ratio` of the allowed one, is small enough. */
static int turns_of(double ratio, double beta) {
    const double root = sqrt(1 + beta), rate = (root - 1) / (root + 1);
    return (int)fmin(fmax(ceil(log(ratio) / -log(rate)), 1), LOOK);
}

/* Solves a = C(d* + dt^2/2 a)/rho; at the end `now` belongs to a, and a to `now` but for TOLERANCE. If the residual
 * grows, or falls too slowly, the iteration starts again, carefully; if it grows then, too, with a larger bound. */
void solid_contact_implicit_solve(struct solid *s, struct solid_contact *c, double half) {
    struct solid_contact_implicit *m = c->implicit;
    const double distance = 2 * sqrt((double)s->dim) * half;
    double least = INFINITY, stiffest = 0, factor = 0.5 * half, seen[SEEN];
    struct pace pace = {0};
    for (int turn = 0, next_check = 0;; turn++) {
        if (turn == next_check || turn == EARLY) solid_contact_implicit_find(s, c, turn == 0);
        push(m);
        if (turn == next_check) {
            measure(m, seen);
            const int may_cross = solid_contact_implicit_solve_crosses(c) &&
                                  (seen[ACROSS] > 0 || distance * seen[LARGEST] > SOLID_CONTACT_NEAR * c->radius),
                      is_new = may_cross && turn > 0 && !m->across;
            const double allowed = fmax(TOLERANCE * seen[LARGEST], QUANTA * c->quantum);
            m->across = may_cross;
            if (!(seen[RESIDUAL] > allowed) && !is_new) break;
            if (turn >= ITERATIONS_MAX) {
                fail(s, m, seen);
                break;
            }
            const int grows = seen[RESIDUAL] > 4 * least, fails = !pace.is_careful && (grows || turn > FEW);
            if (pace.is_careful && seen[RESIDUAL] > least) stop(m);
            if (pace.is_careful && grows) factor *= 2;
            least = fails ? INFINITY : grows ? seen[RESIDUAL] : fmin(least, seen[RESIDUAL]);
            if (fails || grows || seen[STIFFEST] > stiffest) {
                stiffest = seen[STIFFEST];
                pace = pace_of(factor * stiffest, pace.is_careful || fails);
            }
            next_check = turn + turns_of(seen[RESIDUAL] / allowed, factor * stiffest);
            if (fails) {
                start_again(m);
                update_served(s, c);
                continue;
            }
        }
        if (!pace.is_careful) physics_chebyshev_next(&pace.term);
        improve(m, &pace, half);
        update_served(s, c);
    }
    settle(m, half);
}
