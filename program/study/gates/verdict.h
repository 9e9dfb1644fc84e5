/* The line of a gate in summary.csv, or of a number without a tolerance in shown.csv. */
#pragma once
#include <stdio.h>

enum study_gates_rule {
    STUDY_GATES_SHOWN,    /* no tolerance */
    STUDY_GATES_RELATIVE, /* |ours/reference - 1| <= limit */
    STUDY_GATES_BETWEEN,  /* low <= ours <= high */
    STUDY_GATES_AT_LEAST, /* ours >= limit */
    STUDY_GATES_AT_MOST,  /* |ours| <= limit */
    STUDY_GATES_SAME      /* the text of ours is that of the reference */
};

struct study_gates_gate {
    const char *quantity, *unit, *ours, *reference, *source; /* "" where there is none */
    enum study_gates_rule rule;
    const char *limit, *high; /* as written; of BETWEEN the bounds, of SHOWN and SAME NULL */
    int digits;               /* of ours, and of the reference of RELATIVE; 0: as they are */
};

/* Writes the line. Returns whether the number keeps its tolerance; one without a tolerance does. */
int study_gates_verdict_put(FILE *f, const struct study_gates_gate *g);
