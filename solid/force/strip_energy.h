/* Energy of the bonds of one strip (solid/bonds/segments.h): the same text for both widths. The including file defines:
 *     REAL, OF(op)   vec or vec4, and its functions      PLACES   sites of the strip
 *     NAME(name)     the names of the functions here     LANES    sites computed at a time */

/* s^2/eps^2 with 1 + eps = (1 + s)^2; for small eps the series 1/4 (1 - eps/2 + 5/16 eps^2 - ...). */
static inline __attribute__((always_inline)) REAL NAME(square)(REAL e, const int exact) {
    if (exact) {
        const REAL s = 1 / (1 + OF(sqrt)(1 + e));
        return s * s;
    }
    const REAL e2 = e * e;
    return (0.25 - 0.125 * e) + e2 * ((5. / 64 - 7. / 128 * e) + e2 * (21. / 512 - 33. / 1024 * e));
}

/* Adds stiffness |xi|^2 s^2 of the n bonds of the strip at `at`; entry, other as in solid/force/strip.h.
 *     |xi|^2 s^2 = (2 xi.eta + eta.eta) eps (s^2/eps^2) */
static inline __attribute__((always_inline)) void NAME(energy)(const struct solid_boxes *in, long at,
                                                               const uint32_t *entry, const int *other, int n,
                                                               const enum solid_kernel kernel, REAL *sum,
                                                               REAL *largest) {
    const int bulk = (kernel & KERNEL_BULK) != 0, exact = (kernel & KERNEL_EXACT) != 0,
              several = (kernel & KERNEL_SEVERAL) != 0;
    const struct solid_boxes copy = *in, *const box = &copy;
    for (int place = 0; place < PLACES; place += LANES, at += LANES) {
        const REAL x = OF(load)(box->d[0] + at), y = OF(load)(box->d[1] + at), z = OF(load)(box->d[2] + at);
        const REAL w = bulk ? x : OF(load)(box->w + at), half = several ? OF(load)(box->half + at) : x;
        REAL most = *largest, all = *sum;
        for (int i = 0; i < n; i++) {
            const struct solid_lattice_offset *t = &box->offset[entry[i] >> 8];
            const long far = other[i] + place;
            const REAL ex = OF(load)(box->d[0] + far) - x, ey = OF(load)(box->d[1] + far) - y,
                       ez = OF(load)(box->d[2] + far) - z;
            const REAL q = ex * (t->xi2[0] + ex) + ey * (t->xi2[1] + ey) + ez * (t->xi2[2] + ez);
            const REAL eps = OF(where)((entry[i] & 0xffu) >> place, q * t->inv_length2);
            REAL stiff = bulk ? OF(set)(t->elastic) : t->elastic_twice / (w + OF(load)(box->w + far));
            if (several) stiff *= half + OF(load)(box->half + far);
            most = OF(max)(most, OF(max)(eps, -eps));
            all += (q * eps) * (stiff * NAME(square)(eps, exact));
        }
        *largest = most;
        *sum = all;
    }
}
