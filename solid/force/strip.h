/* Bonds of one strip (solid/bonds/segments.h): the same text for both widths and both precisions. The including file
 * defines:
 *     REAL, OF(op)   vec, vec4 or vecf, and its functions           PLACES   sites of the strip
 *     NAME(name)     the names of the functions here                LANES    sites computed at a time
 *     BOXES, OFFSET  struct solid_boxes and solid_lattice_offset, or their namesakes in single
 *     WIDE, WIDE_LOAD, APART   displacements in double or rounded, and a difference of them as a REAL
 * and NAME(g_times), NAME(inverse) as in series_of.h. */

struct NAME(result) {
    REAL high, low; /* of eps over the bonds */
    REAL power;     /* sum of viscous bond forces times closing speeds, of directed bonds, m2/s3 */
};

/* Adds to a  (001: eqs 3.20, 3.41 mended), each bond once if it is paired, from one end if not,
 *     zeta = xi + eta      eps = (2 xi.eta + eta.eta)/|xi|^2 = (1 + s)^2 - 1
 *     a_h += alpha c0 Gamma V/(rho |xi|) g(eps) zeta,   since s zeta/|zeta| = g(eps) zeta/|xi|
 *     a_h += k_d Gamma V/(rho |xi|^2) [(v_l - v_h).zeta]/(1 + eps) zeta,   since |zeta|^2 = (1 + eps) |xi|^2
 *     a_l -= the same                                   the reaction of paired bonds
 * With several materials c0 is (c_h + c_l)/2, and rho the density of kind 0 (solid/bonds/kinds.h).
 * d, v, w, a  arrays  m, m/s, -, m/s2    entry, other [n]  of the strip at `at`: its entries, and their other ends */
static inline __attribute__((always_inline)) void NAME(strip)(const BOXES *in, long at, const uint32_t *entry,
                                                              const int *other, int n, struct NAME(result) * out,
                                                              const enum solid_kernel kernel, const int paired) {
    const int bulk = (kernel & KERNEL_BULK) != 0, exact = (kernel & KERNEL_EXACT) != 0,
              damped = (kernel & KERNEL_DAMPED) != 0, judge = (kernel & KERNEL_JUDGE) != 0,
              mixed = (kernel & KERNEL_MIXED) != 0;
    const BOXES box = *in; /* a copy, so that the compiler knows that no store changes it */
    for (int place = 0; place < PLACES; place += LANES, at += LANES) {
        const WIDE dx = WIDE_LOAD(0, at), dy = WIDE_LOAD(1, at), dz = WIDE_LOAD(2, at);
        REAL w = OF(set)(0), vx = w, vy = w, vz = w, ax = w, ay = w, az = w, power = w;
        REAL high = out->high, low = out->low;
        if (!bulk) w = OF(load)(box.w + at);
        const REAL half = mixed && !judge ? OF(load)(box.half + at) : w,
                   look = mixed && judge ? OF(load)(box.look + at) : w;
        if (damped) {
            vx = OF(load)(box.v[0] + at);
            vy = OF(load)(box.v[1] + at);
            vz = OF(load)(box.v[2] + at);
        }
        for (int i = 0; i < n; i++) {
            const OFFSET *t = &box.offset[entry[i] >> 8];
            const unsigned lambda = (entry[i] & 0xffu) >> place;
            const long far = other[i] + place;
            const REAL ex = APART(WIDE_LOAD(0, far) - dx);
            const REAL ey = APART(WIDE_LOAD(1, far) - dy);
            const REAL ez = APART(WIDE_LOAD(2, far) - dz);
            const REAL zx = t->xi[0] + ex, zy = t->xi[1] + ey, zz = t->xi[2] + ez;
            const REAL q = ex * (t->xi2[0] + ex) + ey * (t->xi2[1] + ey) + ez * (t->xi2[2] + ez);
            const REAL eps = OF(where)(lambda, q * t->inv_length2);
            if (judge && mixed)
                high = OF(max)(high, eps - OF(min)(look, OF(load)(box.look + far)));
            else
                high = OF(max)(high, eps);
            low = OF(min)(low, eps);
            if (judge) continue;
            REAL stiff = OF(set)(t->elastic);
            if (!bulk) stiff = t->elastic_twice / (w + OF(load)(box.w + far));
            if (mixed) stiff *= half + OF(load)(box.half + far);
            REAL f = NAME(g_times)(eps, stiff, exact);
            if (damped) {
                const REAL closing = (OF(load)(box.v[0] + far) - vx) * zx + (OF(load)(box.v[1] + far) - vy) * zy +
                                     (OF(load)(box.v[2] + far) - vz) * zz;
                const REAL fd = OF(where)(lambda, closing * t->viscous) * NAME(inverse)(eps, exact);
                power += fd * closing;
                f += fd;
            }
            const REAL fx = f * zx, fy = f * zy, fz = f * zz;
            ax += fx;
            ay += fy;
            az += fz;
            if (!paired) continue;
            OF(store)(box.a[0] + far, OF(load)(box.a[0] + far) - fx);
            OF(store)(box.a[1] + far, OF(load)(box.a[1] + far) - fy);
            OF(store)(box.a[2] + far, OF(load)(box.a[2] + far) - fz);
        }
        out->high = high;
        out->low = low;
        if (judge) continue;
        out->power += paired ? 2 * power : power;
        OF(store)(box.a[0] + at, OF(load)(box.a[0] + at) + ax);
        OF(store)(box.a[1] + at, OF(load)(box.a[1] + at) + ay);
        OF(store)(box.a[2] + at, OF(load)(box.a[2] + at) + az);
    }
}
