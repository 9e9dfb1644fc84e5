/* Judges a number and writes its line. */
#include "program/study/gates/parts.h"
#include "base/arena.h"
#include "base/files/csv.h"
#include "program/study/text.h"

#include <math.h>
#include <string.h>

/* What is not a finite number, such as nan, is in no range. */
static int passes(const struct study_gates_gate *g) {
    const double x = study_text_number(g->ours), a = study_text_number(g->limit), b = study_text_number(g->high);
    switch (g->rule) {
    case STUDY_GATES_SHOWN:
        return 1;
    case STUDY_GATES_SAME:
        return !strcmp(g->ours, g->reference);
    case STUDY_GATES_RELATIVE:
        return isfinite(x) && fabs(x / study_text_number(g->reference) - 1) <= a;
    case STUDY_GATES_BETWEEN:
        return isfinite(x) && x >= a && x <= b;
    case STUDY_GATES_AT_LEAST:
        return isfinite(x) && x >= a;
    case STUDY_GATES_AT_MOST:
        return isfinite(x) && fabs(x) <= a;
    }
    return 0;
}

static char *tolerance(const struct study_gates_gate *g) {
    switch (g->rule) {
    case STUDY_GATES_SHOWN:
        break;
    case STUDY_GATES_SAME:
        return arena_text("the same");
    case STUDY_GATES_RELATIVE:
        return arena_text("%g relative", study_text_number(g->limit));
    case STUDY_GATES_BETWEEN:
        return arena_text("%s to %s", g->limit, g->high);
    case STUDY_GATES_AT_LEAST:
        return arena_text(">= %s", g->limit);
    case STUDY_GATES_AT_MOST:
        return arena_text("at most %s", g->limit);
    }
    return arena_text("%s", "");
}

static void put_number(FILE *f, const char *text, int digits) {
    const double x = study_text_number(text);
    csv_put(f, isfinite(x) && digits ? arena_text("%.*g", digits, x) : text);
}

int study_gates_verdict_put(FILE *f, const struct study_gates_gate *g) {
    const int held = passes(g);
    csv_put(f, g->quantity);
    fputc(',', f);
    csv_put(f, g->unit);
    fputc(',', f);
    put_number(f, g->ours, g->digits);
    fputc(',', f);
    put_number(f, g->reference, g->rule == STUDY_GATES_RELATIVE ? g->digits : 0);
    fputc(',', f);
    csv_put(f, g->source);
    if (g->rule != STUDY_GATES_SHOWN) {
        fputc(',', f);
        csv_put(f, tolerance(g));
        fputs(held ? ",yes" : ",no", f);
    }
    fputc('\n', f);
    return held;
}
