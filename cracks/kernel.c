/* Sums over struts and links: force of the pressures, volume of the cracks, flow. A vec of a row's lanes at a time. */
#include "cracks/kernel.h"
#include "base/vec.h"

/* The lanes that a vec takes: from lane `lane` of row r on. */
struct part {
    int r, lane, at; /* at: place of the first lane */
    long slot;       /* and its index by slot */
};

static inline struct part part_of(long n, const int *first) {
    const int r = (int)(n / CRACKS_LANES), lane = (int)(n % CRACKS_LANES);
    return (struct part){r, lane, first[r] + lane, n};
}

/* The loop over the parts of all rows. */
#define FOR_EACH_PART(n, rows) for (long n = 0; n < CRACKS_LANES * (long)(rows); n += VEC_LANES)

/* The force of the pressures on the particles of a part, from its struts: the entries from..to-1. */
static inline void pressed(const struct part *h, long from, long to, const struct cracks_entry *entry,
                           const cracks_vec *half, const double *p, vec f[3]) {
    const vec own = vec_load(p + h->at);
    vec x = vec_set(0), y = x, z = x;
    for (long k = from; k < to; k++) {
        const double *half_vector = (const double *)&half[entry[k].kind];
        const vec sum = vec_where(entry[k].lanes >> h->lane, own + vec_load(p + entry[k].at + h->lane));
        x -= sum * half_vector[0];
        y -= sum * half_vector[1];
        z -= sum * half_vector[2];
    }
    f[0] = x;
    f[1] = y;
    f[2] = z;
}

void cracks_kernel_force(int rows, const int *first, const long *start, const long *end,
                         const struct cracks_entry *entry, const cracks_vec *half, const double *p,
                         double *const force[3]) {
    FOR_EACH_PART(n, rows) {
        const struct part h = part_of(n, first);
        vec f[3];
        pressed(&h, start[h.r], end[h.r], entry, half, p, f);
        for (int c = 0; c < 3; c++) vec_store(force[c] + h.slot, f[c]);
    }
}

void cracks_kernel_push(int rows, const int *first, const long *start, const long *end,
                        const struct cracks_entry *entry, const cracks_vec *half, double factor,
                        double *const mobility[3], const double *p, double *const u[3]) {
    FOR_EACH_PART(n, rows) {
        const struct part h = part_of(n, first);
        vec f[3];
        pressed(&h, start[h.r], end[h.r], entry, half, p, f);
        for (int c = 0; c < 3; c++) vec_store(u[c] + h.at, factor * vec_load(mobility[c] + h.slot) * f[c]);
    }
}

void cracks_kernel_volume(int rows, const int *first, const long *start, const long *end,
                          const struct cracks_entry *entry, const cracks_vec *half, double *const u[3],
                          double *volume) {
    FOR_EACH_PART(n, rows) {
        const struct part h = part_of(n, first);
        const vec x = vec_load(u[0] + h.at), y = vec_load(u[1] + h.at), z = vec_load(u[2] + h.at);
        vec sum = vec_set(0);
        for (long k = start[h.r]; k < end[h.r]; k++) {
            const double *f = (const double *)&half[entry[k].kind];
            const int at = entry[k].at + h.lane;
            sum += vec_where(entry[k].lanes >> h.lane, (vec_load(u[0] + at) - x) * f[0] +
                                                           (vec_load(u[1] + at) - y) * f[1] +
                                                           (vec_load(u[2] + at) - z) * f[2]);
        }
        vec_store(volume + h.slot, sum);
    }
}

void cracks_kernel_conductance(int rows, const int *first, const long *start, const long *end,
                               const struct cracks_entry *link, double both, double factor, const double *area,
                               const double *width, double *conductance, double *total) {
    FOR_EACH_PART(n, rows) {
        const struct part h = part_of(n, first);
        const vec a = vec_load(area + h.at), w = vec_load(width + h.at);
        vec sum = vec_set(0);
        for (long k = start[h.r]; k < end[h.r]; k++) {
            const vec mean = 0.5 * (w + vec_load(width + link[k].at + h.lane)),
                      areas = a + vec_load(area + link[k].at + h.lane);
            const vec t = vec_where(link[k].lanes >> h.lane, both + factor * areas * (mean * mean * mean));
            vec_store(conductance + CRACKS_LANES * k + h.lane, t);
            sum += t;
        }
        vec_store(total + h.slot, sum);
    }
}

void cracks_kernel_bound(int rows, const int *first, const long *start, const long *end,
                         const struct cracks_entry *link, const double *most, const double *open, double *conductance,
                         double *total) {
    FOR_EACH_PART(n, rows) {
        const struct part h = part_of(n, first);
        const vec m = vec_load(most + h.at), o = vec_load(open + h.at);
        vec sum = vec_set(0);
        for (long k = start[h.r]; k < end[h.r]; k++) {
            const vec bound = (m + vec_load(most + link[k].at + h.lane)) * (o * vec_load(open + link[k].at + h.lane));
            const vec t =
                vec_where(link[k].lanes >> h.lane, vec_min(vec_load(conductance + CRACKS_LANES * k + h.lane), bound));
            vec_store(conductance + CRACKS_LANES * k + h.lane, t);
            sum += t;
        }
        vec_store(total + h.slot, sum);
    }
}

void cracks_kernel_flow(int rows, const int *first, const long *start, const long *end, const struct cracks_entry *link,
                        const double *conductance, const double *p, double *y) {
    FOR_EACH_PART(n, rows) {
        const struct part h = part_of(n, first);
        const vec own = vec_load(p + h.at);
        vec sum = vec_set(0);
        for (long k = start[h.r]; k < end[h.r]; k++)
            sum += vec_load(conductance + CRACKS_LANES * k + h.lane) * (own - vec_load(p + link[k].at + h.lane));
        vec_store(y + h.slot, sum);
    }
}

void cracks_kernel_scale(int rows, const int *first, double factor, const double *residual, const double *inverse,
                         double *change, double *z) {
    FOR_EACH_PART(n, rows) {
        const struct part h = part_of(n, first);
        const vec moves = factor * vec_load(inverse + h.slot) * vec_load(residual + h.slot);
        vec_store(change + h.slot, moves);
        vec_store(z + h.at, moves);
    }
}

void cracks_kernel_relax(int rows, const int *first, const long *start, const long *end,
                         const struct cracks_entry *link, const float *conductance, double dt, double keep, double gain,
                         const double *residual, const double *inverse, const double *z, double *change, double *next) {
    FOR_EACH_PART(n, rows) {
        const struct part h = part_of(n, first);
        const vec own = vec_load(z + h.at);
        vec flow = vec_set(0);
        for (long k = start[h.r]; k < end[h.r]; k++)
            flow += vec_load_floats(conductance + CRACKS_LANES * k + h.lane) * vec_load(z + link[k].at + h.lane);
        const vec left = vec_load(inverse + h.slot) * (vec_load(residual + h.slot) + dt * flow) - own,
                  moves = keep * vec_load(change + h.slot) + gain * left;
        vec_store(change + h.slot, moves);
        vec_store(next + h.at, own + moves);
    }
}
