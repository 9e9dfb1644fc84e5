/* Sums over struts and links: force of the pressures, volume of the cracks, flow. */
#include "cracks/kernel.h"
#include "base/vec.h"

void cracks_kernel_force(int rows, const int *first, const long *start, const long *end,
                         const struct cracks_entry *entry, const cracks_vec *half, const double *p,
                         double *const force[3]) {
    for (int r = 0; r < rows; r++) {
        const vec own = vec_load(p + first[r]);
        vec x = vec_set(0), y = x, z = x;
        for (long k = start[r]; k < end[r]; k++) {
            const double *h = (const double *)&half[entry[k].kind];
            const vec sum = vec_where(entry[k].lanes, own + vec_load(p + entry[k].at));
            x -= sum * h[0];
            y -= sum * h[1];
            z -= sum * h[2];
        }
        vec_store(force[0] + CRACKS_LANES * (long)r, x);
        vec_store(force[1] + CRACKS_LANES * (long)r, y);
        vec_store(force[2] + CRACKS_LANES * (long)r, z);
    }
}

void cracks_kernel_push(int rows, const int *first, const long *start, const long *end,
                        const struct cracks_entry *entry, const cracks_vec *half, double factor,
                        double *const mobility[3], const double *p, double *const u[3]) {
    for (int r = 0; r < rows; r++) {
        const long seat = CRACKS_LANES * (long)r;
        const vec own = vec_load(p + first[r]);
        vec x = vec_set(0), y = x, z = x;
        for (long k = start[r]; k < end[r]; k++) {
            const double *h = (const double *)&half[entry[k].kind];
            const vec sum = vec_where(entry[k].lanes, own + vec_load(p + entry[k].at));
            x -= sum * h[0];
            y -= sum * h[1];
            z -= sum * h[2];
        }
        vec_store(u[0] + first[r], factor * vec_load(mobility[0] + seat) * x);
        vec_store(u[1] + first[r], factor * vec_load(mobility[1] + seat) * y);
        vec_store(u[2] + first[r], factor * vec_load(mobility[2] + seat) * z);
    }
}

void cracks_kernel_volume(int rows, const int *first, const long *start, const long *end,
                          const struct cracks_entry *entry, const cracks_vec *half, double *const u[3],
                          double *volume) {
    for (int r = 0; r < rows; r++) {
        const vec x = vec_load(u[0] + first[r]), y = vec_load(u[1] + first[r]), z = vec_load(u[2] + first[r]);
        vec sum = vec_set(0);
        for (long k = start[r]; k < end[r]; k++) {
            const double *h = (const double *)&half[entry[k].kind];
            const int at = entry[k].at;
            sum += vec_where(entry[k].lanes, (vec_load(u[0] + at) - x) * h[0] + (vec_load(u[1] + at) - y) * h[1] +
                                                 (vec_load(u[2] + at) - z) * h[2]);
        }
        vec_store(volume + CRACKS_LANES * (long)r, sum);
    }
}

void cracks_kernel_conductance(int rows, const int *first, const long *start, const long *end,
                               const struct cracks_entry *link, double both, double factor, const double *area,
                               const double *width, double *conductance, double *total) {
    for (int r = 0; r < rows; r++) {
        const vec a = vec_load(area + first[r]), w = vec_load(width + first[r]);
        vec sum = vec_set(0);
        for (long k = start[r]; k < end[r]; k++) {
            const vec mean = 0.5 * (w + vec_load(width + link[k].at)), areas = a + vec_load(area + link[k].at);
            const vec t = vec_where(link[k].lanes, both + factor * areas * (mean * mean * mean));
            vec_store(conductance + CRACKS_LANES * k, t);
            sum += t;
        }
        vec_store(total + CRACKS_LANES * (long)r, sum);
    }
}

void cracks_kernel_bound(int rows, const int *first, const long *start, const long *end,
                         const struct cracks_entry *link, const double *most, const double *open, double *conductance,
                         double *total) {
    for (int r = 0; r < rows; r++) {
        const vec m = vec_load(most + first[r]), o = vec_load(open + first[r]);
        vec sum = vec_set(0);
        for (long k = start[r]; k < end[r]; k++) {
            const vec bound = (m + vec_load(most + link[k].at)) * (o * vec_load(open + link[k].at));
            const vec t = vec_where(link[k].lanes, vec_min(vec_load(conductance + CRACKS_LANES * k), bound));
            vec_store(conductance + CRACKS_LANES * k, t);
            sum += t;
        }
        vec_store(total + CRACKS_LANES * (long)r, sum);
    }
}

void cracks_kernel_flow(int rows, const int *first, const long *start, const long *end, const struct cracks_entry *link,
                        const double *conductance, const double *p, double *y) {
    for (int r = 0; r < rows; r++) {
        const vec own = vec_load(p + first[r]);
        vec sum = vec_set(0);
        for (long k = start[r]; k < end[r]; k++)
            sum += vec_load(conductance + CRACKS_LANES * k) * (own - vec_load(p + link[k].at));
        vec_store(y + CRACKS_LANES * (long)r, sum);
    }
}

void cracks_kernel_scale(int rows, const int *first, double factor, const double *residual, const double *inverse,
                         double *change, double *z) {
    for (int r = 0; r < rows; r++) {
        const long seat = CRACKS_LANES * (long)r;
        const vec moves = factor * vec_load(inverse + seat) * vec_load(residual + seat);
        vec_store(change + seat, moves);
        vec_store(z + first[r], moves);
    }
}

void cracks_kernel_relax(int rows, const int *first, const long *start, const long *end,
                         const struct cracks_entry *link, const float *conductance, double dt, double keep, double gain,
                         const double *residual, const double *inverse, const double *z, double *change, double *next) {
    for (int r = 0; r < rows; r++) {
        const long seat = CRACKS_LANES * (long)r;
        const vec own = vec_load(z + first[r]);
        vec flow = vec_set(0);
        for (long k = start[r]; k < end[r]; k++)
            flow += vec_load_floats(conductance + CRACKS_LANES * k) * vec_load(z + link[k].at);
        const vec left = vec_load(inverse + seat) * (vec_load(residual + seat) + dt * flow) - own,
                  moves = keep * vec_load(change + seat) + gain * left;
        vec_store(change + seat, moves);
        vec_store(next + first[r], own + moves);
    }
}
