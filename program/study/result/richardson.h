/* Extrapolation to vanishing step, and the grid convergence index.  (Roache 1994; Celik et al. 2008) Pure. */
#pragma once

enum study_convergence {
    STUDY_UNKNOWN,     /* too few levels */
    STUDY_MONOTONE,    /* differences shrink and have one sign */
    STUDY_OSCILLATORY, /* differences shrink and change sign */
    STUDY_DIVERGENT,   /* differences do not shrink */
    STUDY_FLAT         /* two finest, or all, are equal to the bit */
};

struct study_richardson {
    enum study_convergence kind;
    double order;        /* p, the observed order; NAN: none */
    int capped;          /* 1: the observed order is above the formal one, which was used */
    double extrapolated; /* value at h = 0; NAN: none */
    double gci;          /* of the finest level, in the value's unit: F |f1 - f2|/(r21^p - 1) */
};

/* f, h [3], the finest first, h ascending. The order p solves p ln r21 = ln|e32/e21| + ln((r21^p - s)/(r32^p - s)),
 * s = sign(e32/e21), e21 = f2 - f1, e32 = f3 - f2.  (Celik et al. 2008: eq. 3)
 * F is 1.25. An order above the formal one is chance: the formal one is used, and F is 3 unless the two are within a
 * tenth of each other.  (Roache 2011) */
struct study_richardson study_richardson_three(const double f[3], const double h[3], double formal);
/* The same from two levels with a known order; the index then has the factor 3.  (Roache 1994) */
struct study_richardson study_richardson_two(const double f[2], const double h[2], double order);
const char *study_richardson_name(enum study_convergence kind); /* "monotone", ... */
