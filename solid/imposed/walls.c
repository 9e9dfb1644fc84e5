/* The sides of the domain that push particles back: which particles are near, and the forces on them. */
#include "solid/imposed/walls.h"
#include "base/memory.h"
#include "base/par.h"

#include <math.h>
#include <string.h>

/* In spacings: the distance at which a particle touches a wall, the list's margin, and what counts as on a side. */
static const double TOUCH = 0.5, MARGIN = 0.25, TIE = 1e-9;

/* A particle that may touch a wall, and what the last sweep found of it. */
struct near {
    int h;
    double energy, force[3], d[3]; /* J, N, m: the wall's potential and force, and the displacement */
    double excess; /* J, of the last sweep where the particle met the wall, not its edge, or left it, else 0 */
};

struct wall {
    int c, into;   /* direction of its normal, and the sign of it */
    double at;     /* position along c, m */
    int count[2];  /* squares of a spacing along the other two directions; 1 in a plate's third one */
    double *solid; /* [count[0]][count[1]] 1: particles stand beyond the square from the start; 2: beyond all squares
                    * around it as well; NULL: nowhere */
    int is_open;   /* 1: some of these particles may move away, and others into their place */
    int n, capacity;
    struct near *near; /* [n] owned particles that may touch it */
};

struct solid_walls {
    int n;
    struct wall wall[6];
    double now[3], then[3]; /* forces on the solid in the last sweep and in the one before, this rank's share, N */
    double impulse[3];      /* N s */
    double excess, power;   /* J, W */
    double given;           /* the sum of what solid_walls_excess has returned, J */
};

static double distance(const struct wall *w, double x) { return w->into * (x - w->at); }

/* Where x, m, lies along the k-th direction of a wall, in squares from its edge. */
static double along(const struct solid *s, const struct wall *w, int k, double x) {
    const int c = (w->c + 1 + k) % 3;
    if (c >= s->dim) return 0.5;
    const double q = x / s->in.length[c];
    return w->count[k] * (s->in.periodic[c] ? q - floor(q) : q);
}

/* The index of a square along the k-th direction; beside the domain the last square counts. */
static int wrapped(const struct solid *s, const struct wall *w, int k, int i) {
    const int c = (w->c + 1 + k) % 3, n = w->count[k];
    if (c < s->dim && s->in.periodic[c]) return (i % n + n) % n;
    return i < 0 ? 0 : i < n ? i : n - 1;
}

/* The square of a wall at the position x. */
static int square(const struct solid *s, const struct wall *w, const double x[3]) {
    int at[2];
    for (int k = 0; k < 2; k++) at[k] = wrapped(s, w, k, (int)floor(along(s, w, k, x[(w->c + 1 + k) % 3])));
    return at[0] * w->count[1] + at[1];
}

/* The share of a wall that is there at the position x rises from 0 to 1 between the middles of squares, smoothly: where
 * its slope jumped, so would the force. A body that moves in its own hole has a clearance, in spacings: without it the
 * edge would be where its particles are. slope  1/m, the share's gradient. */
static const double CLEAR = 0.05;
static double share(const struct solid *s, const struct wall *w, const double x[3], double slope[3]) {
    int from[2];
    double part[2];
    for (int c = 0; c < 3; c++) slope[c] = 0;
    if (!w->solid) return 1;
    for (int k = 0; k < 2; k++) {
        const double q = along(s, w, k, x[(w->c + 1 + k) % 3]) - 0.5;
        from[k] = (int)floor(q);
        part[k] = q - from[k];
    }
    double sum = 0;
    for (int corner = 0; corner < 4; corner++) {
        const int i = corner & 1, j = corner >> 1;
        const double at_i = i ? part[0] : 1 - part[0], at_j = j ? part[1] : 1 - part[1];
        if (w->solid[wrapped(s, w, 0, from[0] + i) * w->count[1] + wrapped(s, w, 1, from[1] + j)] > 0) continue;
        sum += at_i * at_j;
        slope[(w->c + 1) % 3] += (i ? 1 : -1) * at_j;
        slope[(w->c + 2) % 3] += (j ? 1 : -1) * at_i;
    }
    const double t = fmax(0, sum - CLEAR) / (1 - CLEAR), rise = 6 * t * (1 - t) / (1 - CLEAR);
    for (int k = 0; k < 2; k++) {
        const int c = (w->c + 1 + k) % 3;
        slope[c] *= c < s->dim ? rise * w->count[k] / s->in.length[c] : 0;
    }
    return t * t * (3 - 2 * t);
}

/* Marks the squares that a particle covers. */
static void cover(const struct solid *s, struct wall *w, int h) {
    for (int corner = 0; corner < 4; corner++) {
        double x[3] = {0};
        for (int c = 0; c < s->dim; c++) x[c] = s->x0[c][h];
        int is_beside = 0;
        for (int k = 0; k < 2; k++) {
            const int c = (w->c + 1 + k) % 3;
            x[c] += (corner >> k & 1 ? 1 : -1) * (TOUCH - TIE) * s->in.spacing;
            is_beside |= c < s->dim && !s->in.periodic[c] && (x[c] < 0 || x[c] > s->in.length[c]);
        }
        if (!is_beside) w->solid[square(s, w, x)] = 1;
    }
}

/* Whether particles stand beyond the square (i, j) and all squares around it. */
static int is_inner(const struct solid *s, const struct wall *w, int i, int j) {
    for (int k = 0; k < 9; k++)
        if (w->solid[wrapped(s, w, 0, i + k % 3 - 1) * w->count[1] + wrapped(s, w, 1, j + k / 3 - 1)] == 0) return 0;
    return 1;
}

/* Finds where particles stand beyond the wall. Collective. */
static void find_solid(const struct solid *s, struct wall *w) {
    const double beyond = -TIE * s->in.spacing;
    double any = 0;
    for (int h = 0; h < s->n; h++)
        if (distance(w, s->x0[w->c][h]) < beyond) any = fmax(any, s->flag[h] >> w->c & SOLID_HELD_X ? 1 : 2);
    any = par_max(any);
    w->is_open = any > 1;
    if (any == 0) return;
    const int n = w->count[0] * w->count[1];
    w->solid = memory_new(MEMORY_SOLID, (size_t)n, sizeof *w->solid);
    for (int h = 0; h < s->n; h++)
        if (distance(w, s->x0[w->c][h]) < beyond) cover(s, w, h);
    par_max_array(w->solid, n);
    for (int i = 0; i < n; i++)
        if (is_inner(s, w, i / w->count[1], i % w->count[1])) w->solid[i] = 2;
}

static void wall_new(const struct solid *s, struct wall *w, int c, int high) {
    *w = (struct wall){.c = c, .into = high ? -1 : 1, .at = high ? s->in.length[c] : 0, .count = {1, 1}};
    for (int k = 0; k < 2; k++) {
        const int along = (c + 1 + k) % 3;
        if (along < s->dim) w->count[k] = (int)fmax(1, rint(s->in.length[along] / s->in.spacing));
    }
    find_solid(s, w);
}

void solid_walls_new(struct solid *s) {
    int n = 0;
    for (int c = 0; c < s->dim; c++) n += s->in.wall[c][0] + s->in.wall[c][1];
    if (n == 0 || s->in.rigid) return;
    struct solid_walls *walls = s->walls = memory_new(MEMORY_SOLID, 1, sizeof *walls);
    for (int c = 0; c < s->dim; c++)
        for (int high = 0; high < 2; high++)
            if (s->in.wall[c][high]) wall_new(s, &walls->wall[walls->n++], c, high);
}

void solid_walls_free(struct solid_walls *walls) {
    if (!walls) return;
    for (int k = 0; k < walls->n; k++) MEMORY_FREE(walls->wall[k].solid, walls->wall[k].near);
    memory_free(walls);
}

/* N/m4 */
static double stiffness_of(const struct solid *s, const struct solid_material *m) {
    const double horizon = m->horizon_ratio * s->in.spacing;
    return 4 * m->youngs_modulus / (horizon * horizon);
}

static double stiffness(const struct solid *s, int h) {
    return stiffness_of(s, &s->in.material[solid_particle_material(s, h)]);
}

/* Largest eigenvalue of the potential's second derivatives over k, at a depth of up to half a spacing where a wall's
 * share rises from 0 to 1: at the corner of a hole. Deeper in it grows with the square of the depth. */
static const double AT_EDGE = 1.56;

double solid_walls_rate(const struct solid *s) {
    double most = 0, edge = 1;
    for (int k = 0; s->walls && k < s->walls->n; k++)
        if (s->walls->wall[k].solid) edge = AT_EDGE;
    for (int m = 0; s->walls && m < s->in.materials; m++)
        most = fmax(most, edge * stiffness_of(s, &s->in.material[m]) / s->in.material[m].density);
    return most;
}

static double depth(const struct solid *s, const struct wall *w, int h) {
    const double start = distance(w, s->x0[w->c][h]);
    return fmin(TOUCH * s->in.spacing, start) - (start + w->into * s->d[w->c][h]);
}

/* The potential and the force of a wall on a particle that is deep in it, with the share w of the wall:
 * k w deep^2/2 and minus its gradient. */
static void press(const struct solid *s, const struct wall *w, struct near *near) {
    const int h = near->h;
    double x[3], slope[3];
    const double deep = depth(s, w, h);
    near->energy = near->force[0] = near->force[1] = near->force[2] = near->excess = 0;
    for (int c = 0; c < s->dim; c++) near->d[c] = s->d[c][h];
    if (deep <= 0) return;
    solid_position(s, h, x);
    const double w_h = share(s, w, x, slope), k_h = s->volume[h] * stiffness(s, h);
    near->energy = 0.5 * k_h * w_h * deep * deep;
    for (int c = 0; c < s->dim; c++)
        near->force[c] = c == w->c ? w->into * k_h * w_h * deep : -0.5 * k_h * deep * deep * slope[c];
}

static int is_at_edge(const struct wall *w, const struct near *near) {
    return near->force[(w->c + 1) % 3] != 0 || near->force[(w->c + 2) % 3] != 0;
}

/* Whether a particle may touch the wall before the list is renewed. */
static int is_near(const struct solid *s, const struct wall *w, int h, double reach) {
    double x[3];
    const double start = distance(w, s->x0[w->c][h]);
    if (start + w->into * s->d[w->c][h] >= reach || start < -TIE * s->in.spacing) return 0;
    if (s->flag[h] & (unsigned)SOLID_HELD_X << w->c) return 0;
    if (!w->solid) return 1;
    solid_position(s, h, x);
    return w->solid[square(s, w, x)] < 2;
}

static void add(const struct solid *s, struct wall *w, int h) {
    MEMORY_MORE(MEMORY_SOLID, w->near, w->n, w->capacity);
    w->near[w->n].h = h;
    press(s, w, &w->near[w->n++]);
}

void solid_walls_list(struct solid *s) {
    if (!s->walls) return;
    const double reach = (TOUCH + MARGIN) * s->in.spacing;
    s->walls->excess = 0; /* what RK3 left, which does not ask for it */
    for (int k = 0; k < s->walls->n; k++) {
        struct wall *w = &s->walls->wall[k];
        w->n = 0;
        for (int h = 0; h < s->n; h++)
            if (is_near(s, w, h, reach)) add(s, w, h);
    }
}

int solid_walls_are_open(const struct solid *s) {
    int any = 0;
    for (int k = 0; s->walls && k < s->walls->n; k++) any |= s->walls->wall[k].is_open;
    return any;
}

/* Whether particles stand beyond a wall, which has an edge around them. */
static int have_edges(const struct solid *s) {
    int any = 0;
    for (int k = 0; s->walls && k < s->walls->n; k++) any |= s->walls->wall[k].solid != NULL;
    return any;
}

/* The edge's stiffness changes within a few substeps, in which velocity Verlet gains energy: with once the rate 20 % in
 * a body that slides out of its hole. */
static const double CHANGES = 2;

/* Whether a particle is at the edge now, or will be after `ahead`, s, with its present velocity. */
static int meets_edge(const struct solid *s, const struct wall *w, const struct near *near, double ahead) {
    double x[3], slope[3];
    if (is_at_edge(w, near)) return 1;
    solid_position(s, near->h, x);
    for (int c = 0; c < s->dim; c++) x[c] += ahead * s->v[c][near->h];
    share(s, w, x, slope);
    return slope[0] != 0 || slope[1] != 0 || slope[2] != 0;
}

double solid_walls_rate_deep(struct solid *s, double ahead) {
    double most = 0;
    if (!have_edges(s)) return 0;
    solid_walls_list(s);
    for (int k = 0; k < s->walls->n; k++)
        for (int i = 0; i < s->walls->wall[k].n; i++) {
            const struct wall *w = &s->walls->wall[k];
            const int h = w->near[i].h;
            const double deep = (depth(s, w, h) + ahead * fabs(s->v[w->c][h])) / (TOUCH * s->in.spacing);
            if (deep > 1 && meets_edge(s, w, &w->near[i], ahead))
                most = fmax(most, CHANGES * AT_EDGE * deep * deep * stiffness(s, h) / solid_density(s, h));
        }
    return par_max(most);
}

/* Adds the force on a particle, and what its work exceeds the loss of potential by. */
static void push(struct solid *s, struct solid_walls *walls, const struct wall *w, struct near *near) {
    const struct near then = *near;
    press(s, w, near);
    if (near->energy == 0 && then.energy == 0) return;
    const double mass = solid_density(s, near->h) * s->volume[near->h];
    double excess = near->energy - then.energy;
    for (int c = 0; c < s->dim; c++) {
        const double force = near->force[c];
        excess += 0.5 * (force + then.force[c]) * (near->d[c] - then.d[c]);
        walls->power += force * s->v[c][near->h];
        walls->now[c] += force;
        s->a[c][near->h] += force / mass;
    }
    walls->excess += excess;
    if ((near->energy == 0 || then.energy == 0) && !is_at_edge(w, near) && !is_at_edge(w, &then)) near->excess = excess;
}

void solid_walls_push(struct solid *s) {
    struct solid_walls *walls = s->walls;
    memcpy(walls->then, walls->now, sizeof walls->then);
    memset(walls->now, 0, sizeof walls->now);
    walls->power = 0;
    for (int k = 0; k < walls->n; k++)
        for (int i = 0; i < walls->wall[k].n; i++) push(s, walls, &walls->wall[k], &walls->wall[k].near[i]);
}

/* The change of a velocity v after which mass v^2/2 is less by the excess, at most by all of it. */
static double change_of(double mass, double v, double excess) {
    return copysign(sqrt(fmax(0, v * v - 2 * excess / mass)), v) - v;
}

/* No bond pulls the particle: the last sweep has left the pairs' part of its acceleration in v_old. */
static int is_loose(const struct solid *s, int h) {
    for (int c = 0; c < s->dim; c++)
        if (s->v_old[c][h] != 0) return 0;
    return 1;
}

/* A particle is slow if other forces would give it its velocity in so many substeps. It is given nothing, and taken
 * from if it is loose, so that it comes to rest. */
static const double SLOW = 1.75;

void solid_walls_correct(struct solid *s, double dt) {
    for (int k = 0; s->walls && k < s->walls->n; k++) {
        const struct wall *w = &s->walls->wall[k];
        for (int i = 0; i < w->n; i++) {
            const struct near *near = &w->near[i];
            if (near->excess == 0) continue;
            const double mass = solid_density(s, near->h) * s->volume[near->h], v = s->v[w->c][near->h],
                         others = s->a[w->c][near->h] - near->force[w->c] / mass;
            const int is_slow = fabs(v) < SLOW * dt * fabs(others);
            if (is_slow && (near->excess < 0 || !is_loose(s, near->h))) continue;
            const double change = change_of(mass, v, near->excess);
            s->v[w->c][near->h] += change;
            s->walls->impulse[w->c] += mass * change;
            s->walls->excess += mass * change * (v + 0.5 * change);
        }
    }
}

double solid_walls_energy(const struct solid *s) {
    double sum = 0;
    for (int k = 0; s->walls && k < s->walls->n; k++) {
        const struct wall *w = &s->walls->wall[k];
        for (int i = 0; i < w->n; i++) {
            struct near near = {.h = w->near[i].h};
            press(s, w, &near);
            sum += near.energy;
        }
    }
    return sum;
}

double solid_walls_excess(struct solid *s) {
    const double excess = s->walls ? s->walls->excess : 0;
    if (s->walls) s->walls->excess = 0;
    if (s->walls) s->walls->given += excess;
    return excess;
}

double solid_walls_given(const struct solid *s) { return s->walls ? s->walls->given : 0; }

double solid_walls_power(const struct solid *s) { return s->walls ? s->walls->power : 0; }

void solid_walls_impulse_begin(struct solid *s) {
    if (s->walls) memset(s->walls->impulse, 0, sizeof s->walls->impulse);
}

void solid_walls_impulse_add(struct solid *s, double now, double then) {
    struct solid_walls *w = s->walls;
    for (int c = 0; w && c < s->dim; c++) w->impulse[c] += now * w->now[c] + then * w->then[c];
}

void solid_walls_impulse(const struct solid *s, double impulse[3]) {
    for (int c = 0; s->walls && c < s->dim; c++) impulse[c] += s->walls->impulse[c];
}
