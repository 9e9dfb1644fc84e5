/* The sides of the domain that push particles back: which particles are near, and the forces on them. */
#include "solid/imposed/walls.h"
#include "base/memory.h"
#include "base/par.h"

#include <math.h>
#include <string.h>

/* In spacings: the distance at which a particle touches a wall, the list's margin, and what counts as on a side. */
static const double TOUCH = 0.5, MARGIN = 0.25, TIE = 1e-9;

struct wall {
    int c, into;   /* direction of its normal, and the sign of it */
    double at;     /* position along c, m */
    int count[2];  /* squares of a spacing along the other two directions; 1 in a plate's third one */
    double *solid; /* [count[0]][count[1]] 1: particles stand beyond the square from the start; 2: beyond all squares
                    * around it as well; NULL: nowhere */
    int n, capacity;
    int *h;          /* [n] owned particles that may touch it */
    double *pushed;  /* [n] their depth in the last sweep, m */
    double *reached; /* [n] their displacement along the normal in it, m */
};

struct solid_walls {
    int n;
    struct wall wall[6];
    double now[3], then[3]; /* forces on the solid in the last sweep and in the one before, this rank's share, N */
    double impulse[3];      /* N s */
    double excess, power;   /* J, W */
};

static double distance(const struct wall *w, double x) { return w->into * (x - w->at); }

/* The square of a wall at the position x, -1: beside the domain. */
static int square(const struct solid *s, const struct wall *w, const double x[3]) {
    int at[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        const int c = (w->c + 1 + k) % 3;
        if (c >= s->dim) continue;
        double q = x[c] / s->in.length[c];
        if (s->in.periodic[c]) q -= floor(q);
        if (q < 0 || q > 1) return -1;
        at[k] = (int)fmin(q * w->count[k], w->count[k] - 1);
    }
    return at[0] * w->count[1] + at[1];
}

/* Marks the squares that a particle covers. */
static void cover(const struct solid *s, struct wall *w, int h) {
    for (int corner = 0; corner < 4; corner++) {
        double x[3] = {0};
        for (int c = 0; c < s->dim; c++) x[c] = s->x0[c][h];
        for (int k = 0; k < 2; k++) x[(w->c + 1 + k) % 3] += (corner >> k & 1 ? 1 : -1) * (TOUCH - TIE) * s->in.spacing;
        const int i = square(s, w, x);
        if (i >= 0) w->solid[i] = 1;
    }
}

/* Whether particles stand beyond the square (i, j) and all squares around it, or the domain ends there. */
static int is_inner(const struct solid *s, const struct wall *w, int i, int j) {
    const int at[2] = {i, j};
    for (int k = 0; k < 9; k++) {
        int x[2] = {at[0] + k % 3 - 1, at[1] + k / 3 - 1}, is_beside = 0;
        for (int q = 0; q < 2; q++) {
            const int c = (w->c + 1 + q) % 3, is_out = x[q] < 0 || x[q] >= w->count[q];
            if (is_out && c < s->dim && s->in.periodic[c]) x[q] = (x[q] + w->count[q]) % w->count[q];
            is_beside |= x[q] < 0 || x[q] >= w->count[q];
        }
        if (!is_beside && w->solid[x[0] * w->count[1] + x[1]] == 0) return 0;
    }
    return 1;
}

/* Finds where particles stand beyond the wall. Collective. */
static void find_solid(const struct solid *s, struct wall *w) {
    const double beyond = TIE * s->in.spacing;
    double any = 0;
    for (int h = 0; h < s->n; h++) any = fmax(any, distance(w, s->x0[w->c][h]) < beyond);
    if (par_max(any) == 0) return;
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
    for (int k = 0; k < walls->n; k++) {
        memory_free(walls->wall[k].solid);
        memory_free(walls->wall[k].h);
        memory_free(walls->wall[k].pushed);
        memory_free(walls->wall[k].reached);
    }
    memory_free(walls);
}

static void add(struct wall *w, int h) {
    if (w->n == w->capacity) {
        const size_t n = (size_t)w->n, capacity = 2 * n + 64;
        w->h = memory_grown(MEMORY_SOLID, w->h, n, capacity, sizeof *w->h);
        w->pushed = memory_grown(MEMORY_SOLID, w->pushed, n, capacity, sizeof *w->pushed);
        w->reached = memory_grown(MEMORY_SOLID, w->reached, n, capacity, sizeof *w->reached);
        w->capacity = (int)capacity;
    }
    w->h[w->n++] = h;
}

/* How deep a listed particle is in the wall, m; 0: it does not touch. */
static double depth(const struct solid *s, const struct wall *w, int h) {
    double x[3];
    const double start = distance(w, s->x0[w->c][h]), now = start + w->into * s->d[w->c][h],
                 least = fmin(TOUCH * s->in.spacing, start);
    if (now >= least) return 0;
    solid_position(s, h, x);
    const int i = square(s, w, x);
    return i < 0 || (w->solid && w->solid[i] > 0) ? 0 : least - now;
}

/* N/m4 */
static double stiffness_of(const struct solid *s, const struct solid_material *m) {
    const double horizon = m->horizon_ratio * s->in.spacing;
    return 4 * m->youngs_modulus / (horizon * horizon);
}

static double stiffness(const struct solid *s, int h) {
    return stiffness_of(s, &s->in.material[solid_particle_material(s, h)]);
}

double solid_walls_rate(const struct solid *s) {
    double most = 0;
    for (int m = 0; s->walls && m < s->in.materials; m++)
        most = fmax(most, stiffness_of(s, &s->in.material[m]) / s->in.material[m].density);
    return most;
}

/* Whether a particle may touch the wall before the list is renewed. */
static int is_near(const struct solid *s, const struct wall *w, int h, double reach) {
    double x[3];
    const double start = distance(w, s->x0[w->c][h]);
    if (start + w->into * s->d[w->c][h] >= reach || start < TIE * s->in.spacing) return 0;
    if (s->flag[h] & (unsigned)SOLID_HELD_X << w->c) return 0;
    if (!w->solid) return 1;
    solid_position(s, h, x);
    const int i = square(s, w, x);
    return i < 0 || w->solid[i] < 2;
}

void solid_walls_list(struct solid *s) {
    if (!s->walls) return;
    const double reach = (TOUCH + MARGIN) * s->in.spacing;
    s->walls->excess = 0; /* what RK3 left, which does not ask for it */
    for (int k = 0; k < s->walls->n; k++) {
        struct wall *w = &s->walls->wall[k];
        w->n = 0;
        for (int h = 0; h < s->n; h++)
            if (is_near(s, w, h, reach)) add(w, h);
        for (int i = 0; i < w->n; i++) {
            w->pushed[i] = depth(s, w, w->h[i]);
            w->reached[i] = w->into * s->d[w->c][w->h[i]];
        }
    }
}

void solid_walls_push(struct solid *s) {
    struct solid_walls *walls = s->walls;
    memcpy(walls->then, walls->now, sizeof walls->then);
    memset(walls->now, 0, sizeof walls->now);
    walls->power = 0;
    for (int k = 0; k < walls->n; k++) {
        const struct wall *w = &walls->wall[k];
        for (int i = 0; i < w->n; i++) {
            const int h = w->h[i];
            const double deep = depth(s, w, h), before = w->pushed[i], now = w->into * s->d[w->c][h],
                         way = now - w->reached[i];
            w->pushed[i] = deep;
            w->reached[i] = now;
            if (deep == 0 && before == 0) continue;
            const double k_h = s->volume[h] * stiffness(s, h), force = w->into * k_h * deep;
            walls->excess += 0.5 * k_h * (deep + before) * (way + deep - before);
            walls->power += force * s->v[w->c][h];
            walls->now[w->c] += force;
            s->a[w->c][h] += force / (solid_density(s, h) * s->volume[h]);
        }
    }
}

double solid_walls_energy(const struct solid *s) {
    double sum = 0;
    for (int k = 0; s->walls && k < s->walls->n; k++) {
        const struct wall *w = &s->walls->wall[k];
        for (int i = 0; i < w->n; i++) {
            const double deep = depth(s, w, w->h[i]);
            sum += 0.5 * s->volume[w->h[i]] * stiffness(s, w->h[i]) * deep * deep;
        }
    }
    return sum;
}

double solid_walls_excess(struct solid *s) {
    const double excess = s->walls ? s->walls->excess : 0;
    if (s->walls) s->walls->excess = 0;
    return excess;
}

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
