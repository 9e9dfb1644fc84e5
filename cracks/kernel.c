/* Sums over struts and links: force of the pressures, volume of the cracks, flow. */
#include "cracks/kernel.h"

void cracks_kernel_force(int n, const long *start, const int *other, const uint16_t *kind, const cracks_vec *half,
                         const double *p, cracks_vec *force) {
    for (int i = 0; i < n; i++) {
        const double own = p[i];
        cracks_vec sum = {0};
        for (long k = start[i]; k < start[i + 1]; k++) sum += (own + p[other[k]]) * half[kind[k]];
        force[i] = -sum;
    }
}

void cracks_kernel_volume_part(int n, const long *start, const long *end, const int *other, const uint16_t *kind,
                               const cracks_vec *half, const cracks_vec *u, double *volume) {
    for (int i = 0; i < n; i++) {
        const cracks_vec own = u[i];
        cracks_vec sum = {0};
        for (long k = start[i]; k < end[i]; k++) sum += (u[other[k]] - own) * half[kind[k]];
        volume[i] = cracks_kernel_sum(sum);
    }
}

void cracks_kernel_volume(int n, const long *start, const int *other, const uint16_t *kind, const cracks_vec *half,
                          const cracks_vec *u, double *volume) {
    cracks_kernel_volume_part(n, start, start + 1, other, kind, half, u, volume);
}

void cracks_kernel_flow(int n, const int *start, const int *link, const double *conductance, double factor,
                        const double *p, double *y) {
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int k = start[i]; k < start[i + 1]; k++) sum += conductance[k] * (p[i] - p[link[k]]);
        y[i] += factor * sum;
    }
}
