/* Bonds of one strip (solid/bonds/segments.h): the same text for both widths and both precisions. The including file
 * defines:
 *     REAL, OF(op)   vec, vec4 or vecf, and its functions           PLACES   sites of the strip
 *     NAME(name)     the names of the functions here                LANES    sites computed at a time
 *     BOXES, OFFSET  struct solid_boxes and solid_lattice_offset, or their namesakes in single
 *     WIDE, WIDE_LOAD, DIFFERENCE   displacements in double or rounded, and a difference of them as a REAL
 * and NAME(g_times), NAME(s_times), NAME(inverse) as in series_of.h. */

struct NAME(result) {
    REAL high, low; /* of eps over the bonds */
    REAL power;     /* sum of viscous bond forces times closing speeds, of directed bonds, m2/s3 */
};

/* At one place of a strip: what its bonds need of their first ends, and sums over them. */
struct NAME(first_end) {
    WIDE dx, dy, dz;
    REAL vx, vy, vz, w, half, threshold, pressure;
    REAL ax, ay, az, high, low, power;
};

/* Adds to a  (001: eqs 3.20, 3.41 mended), each bond once if it is paired, from one end if not,
 *     zeta = xi + eta      eps = (2 xi.eta + eta.eta)/|xi|^2 = (1 + s)^2 - 1
 *     a_h += alpha c0 Gamma V/(rho |xi|) g(eps) zeta,   since s zeta/|zeta| = g(eps) zeta/|xi|
 *     a_h += k_d Gamma V/(rho |xi|^2) [(v_l - v_h).zeta]/(1 + eps) zeta,   since |zeta|^2 = (1 + eps) |xi|^2
 *     a_l -= the same                                   the reaction of paired bonds
 * With several materials c0 is (c_h + c_l)/2, and rho the density of kind 0 (solid/bonds/materials.h).
 * With any Poisson's ratio (solid/force/dilatation.h), K for c0 Gamma V/(rho |xi|) and P for the pressure,
 *     a_h += K [alpha g + (P_h + P_l)(1 - g)] zeta      since zeta/|zeta| = (1 - g) zeta/|xi|
 * and with KERNEL_EXTENSION, in place of a force and the same from both ends,
 *     a_h[0] += K |xi|^2 s        a_h[1] += K |xi|^2
 * d, v, w, a  arrays  m, m/s, -, m/s2    entry, other [many]  entries at `place` of their strip, and their other ends
 * Two entries at a time: the chains of dependent operations of the one run beside those of the other. */
static inline __attribute__((always_inline)) void NAME(bonds)(const BOXES *box, int place, const uint32_t *entry,
                                                              const int *other, struct NAME(first_end) * h,
                                                              const enum solid_kernel kernel, const int paired,
                                                              const int many) {
    const int bulk = (kernel & KERNEL_BULK) != 0, damped = (kernel & KERNEL_DAMPED) != 0,
              stretch_only = (kernel & KERNEL_STRETCH_ONLY) != 0, several = (kernel & KERNEL_SEVERAL) != 0,
              extension = (kernel & KERNEL_EXTENSION) != 0, pressed = (kernel & KERNEL_PRESSED) != 0;
    const enum solid_series series = kernel & KERNEL_EXACT ? SERIES_LONG : SERIES_SHORT;
    const OFFSET *t[2];
    long far[2];
    REAL zx[2], zy[2], zz[2], q[2], eps[2], stiff[2], plain[2], f[2];
    for (int k = 0; k < many; k++) {
        t[k] = &box->offset[entry[k] >> 8];
        far[k] = other[k] + place;
    }
    for (int k = 0; k < many; k++) {
        const REAL ex = DIFFERENCE(WIDE_LOAD(0, far[k]) - h->dx);
        const REAL ey = DIFFERENCE(WIDE_LOAD(1, far[k]) - h->dy);
        const REAL ez = DIFFERENCE(WIDE_LOAD(2, far[k]) - h->dz);
        zx[k] = t[k]->xi[0] + ex, zy[k] = t[k]->xi[1] + ey, zz[k] = t[k]->xi[2] + ez;
        q[k] = ex * (t[k]->xi2[0] + ex) + ey * (t[k]->xi2[1] + ey) + ez * (t[k]->xi2[2] + ez);
    }
    for (int k = 0; k < many; k++) {
        eps[k] = OF(where)((entry[k] & 0xffu) >> place, q[k] * t[k]->inv_length2);
        if (!pressed) {
            h->high = OF(max)(h->high, stretch_only && several
                                           ? eps[k] - OF(min)(h->threshold, OF(load)(box->threshold + far[k]))
                                           : eps[k]);
            h->low = OF(min)(h->low, eps[k]);
        }
        if (stretch_only) continue;
        stiff[k] = bulk ? OF(set)(t[k]->elastic) : t[k]->elastic_twice / (h->w + OF(load)(box->w + far[k]));
        if (extension || pressed) plain[k] = OF(set)(t[k]->elastic);
        if (!several) continue;
        const REAL halves = h->half + OF(load)(box->half + far[k]);
        stiff[k] *= halves;
        if (extension || pressed) plain[k] *= halves;
    }
    for (int k = 0; k < many && !stretch_only; k++) {
        if (extension) {
            plain[k] = OF(where)((entry[k] & 0xffu) >> place, plain[k] * t[k]->length2);
            f[k] = NAME(s_times)(eps[k], plain[k], series);
            continue;
        }
        if (pressed) {
            const REAL g = NAME(g_times)(eps[k], OF(set)(1), series),
                       p = OF(where)((entry[k] & 0xffu) >> place, h->pressure + OF(load)(box->pressure + far[k]));
            f[k] = stiff[k] * g + plain[k] * (p * (1 - g));
        } else {
            f[k] = NAME(g_times)(eps[k], stiff[k], series);
        }
        if (!damped) continue;
        const REAL closing = (OF(load)(box->v[0] + far[k]) - h->vx) * zx[k] +
                             (OF(load)(box->v[1] + far[k]) - h->vy) * zy[k] +
                             (OF(load)(box->v[2] + far[k]) - h->vz) * zz[k];
        const REAL fd = OF(where)((entry[k] & 0xffu) >> place, closing * t[k]->viscous) * NAME(inverse)(eps[k], series);
        h->power += fd * closing;
        f[k] += fd;
    }
    for (int k = 0; k < many && extension; k++) {
        h->ax += f[k];
        h->ay += plain[k];
        if (!paired) continue;
        OF(store)(box->a[0] + far[k], OF(load)(box->a[0] + far[k]) + f[k]);
        OF(store)(box->a[1] + far[k], OF(load)(box->a[1] + far[k]) + plain[k]);
    }
    for (int k = 0; k < many && !stretch_only && !extension; k++) {
        const REAL fx = f[k] * zx[k], fy = f[k] * zy[k], fz = f[k] * zz[k];
        h->ax += fx;
        h->ay += fy;
        h->az += fz;
        if (!paired) continue;
        OF(store)(box->a[0] + far[k], OF(load)(box->a[0] + far[k]) - fx);
        OF(store)(box->a[1] + far[k], OF(load)(box->a[1] + far[k]) - fy);
        OF(store)(box->a[2] + far[k], OF(load)(box->a[2] + far[k]) - fz);
    }
}

/* The n bonds of the strip at `at`; entry, other as above. */
static inline __attribute__((always_inline)) void NAME(strip)(const BOXES *in, long at, const uint32_t *entry,
                                                              const int *other, int n, struct NAME(result) * out,
                                                              const enum solid_kernel kernel, const int paired) {
    const int bulk = (kernel & KERNEL_BULK) != 0, damped = (kernel & KERNEL_DAMPED) != 0,
              stretch_only = (kernel & KERNEL_STRETCH_ONLY) != 0, several = (kernel & KERNEL_SEVERAL) != 0,
              pressed = (kernel & KERNEL_PRESSED) != 0;
    const BOXES copy = *in, *const box = &copy; /* a copy, so that the compiler knows that no store changes it */
    const REAL zero = OF(set)(0);
    for (int place = 0; place < PLACES; place += LANES, at += LANES) {
        struct NAME(first_end) h;
        h.dx = WIDE_LOAD(0, at);
        h.dy = WIDE_LOAD(1, at);
        h.dz = WIDE_LOAD(2, at);
        h.vx = damped ? OF(load)(box->v[0] + at) : zero;
        h.vy = damped ? OF(load)(box->v[1] + at) : zero;
        h.vz = damped ? OF(load)(box->v[2] + at) : zero;
        h.w = bulk ? zero : OF(load)(box->w + at);
        h.half = several && !stretch_only ? OF(load)(box->half + at) : zero;
        h.threshold = several && stretch_only ? OF(load)(box->threshold + at) : zero;
        h.pressure = pressed ? OF(load)(box->pressure + at) : zero;
        h.ax = h.ay = h.az = h.power = zero;
        h.high = out->high;
        h.low = out->low;
        int i = 0;
        for (; i + 2 <= n; i += 2) NAME(bonds)(box, place, entry + i, other + i, &h, kernel, paired, 2);
        if (i < n) NAME(bonds)(box, place, entry + i, other + i, &h, kernel, paired, 1);
        out->high = h.high;
        out->low = h.low;
        if (stretch_only) continue;
        out->power += paired ? 2 * h.power : h.power;
        OF(store)(box->a[0] + at, OF(load)(box->a[0] + at) + h.ax);
        OF(store)(box->a[1] + at, OF(load)(box->a[1] + at) + h.ay);
        if (kernel & KERNEL_EXTENSION) continue;
        OF(store)(box->a[2] + at, OF(load)(box->a[2] + at) + h.az);
    }
}
