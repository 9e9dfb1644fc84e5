/* Names, description of the machine and status texts, shared by the CSV file and the page. */
#include "program/study/report/report.h"
#include "base/libraries.h"
#include "base/machine.h"
#include "base/arena.h"
#include "base/version.h"
#include "program/study/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

struct study_maker study_report_maker(void) {
    struct study_maker m = {.cores = machine_cores()};
    char library[3][128];
    const time_t now = time(NULL);
    libraries_describe(library);
    machine_processor(m.processor, sizeof m.processor);
    snprintf(m.compiler, sizeof m.compiler, "%s", FRANA_COMPILER);
    snprintf(m.flags, sizeof m.flags, "%s", FRANA_FLAGS);
    snprintf(m.version, sizeof m.version, "%s", FRANA_VERSION);
    snprintf(m.revision, sizeof m.revision, "%s", FRANA_REVISION);
    snprintf(m.mpi, sizeof m.mpi, "%s", library[0]);
    snprintf(m.fftw, sizeof m.fftw, "%s", library[2]);
    strftime(m.date, sizeof m.date, "%Y-%m-%d", gmtime(&now));
    return m;
}

char *study_report_name(const struct study_result *r, const struct study_table *t) {
    const char *name = r->plan->study->name;
    if (r->tables == 1) return arena_text("%s", name);
    return arena_text("%s_%s", name, study_text_slug(t->quantity->name));
}

const char *study_report_status(const struct study_point *p, char status[32]) {
    if (p->state == STUDY_FAILED)
        snprintf(status, 32, "failed %d", p->exit_code);
    else if (p->exit_code)
        snprintf(status, 32, "done; a repeat failed %d", p->exit_code);
    else
        snprintf(status, 32, "%s", p->state != STUDY_DONE ? "not run" : p->repeats ? "done" : "no value");
    return status;
}

char *study_report_reference(const struct study_result *r, const struct study_table *t) {
    const struct study_reference *ref = &t->quantity->reference;
    const char *unit = t->quantity->unit, *blank = *unit ? " " : "";
    char sure[48] = "";
    if (t->uncertainty > 0) snprintf(sure, sizeof sure, " ± %.2g", t->uncertainty);
    if (t->method < 0)
        return arena_text("%.10g%s%s%s%s%s", t->reference, blank, unit, sure, ref->source ? ", " : "",
                          ref->source ? ref->source : "");
    const struct study_variants *methods = &r->plan->study->methods, *levels = &r->plan->study->levels;
    const char *method = methods->variant[t->method].name;
    const struct study_curve *c = &t->curve[t->method];
    if (c->finest < 0) return arena_text("none: no run of %s gave a value", method);
    const char *level = levels->variant[c->finest].name;
    if (t->extrapolated && c->richardson.capped)
        return arena_text(
            "%.10g%s%s%s, extrapolated from the finest levels of %s (to %s) with the formal order %g, as the "
            "observed one, %.2f, is higher; the uncertainty is the grid convergence index",
            t->reference, blank, unit, sure, method, level, ref->formal, c->richardson.order);
    if (t->extrapolated)
        return arena_text("%.10g%s%s%s, extrapolated from the finest levels of %s (to %s) with %s order %.2f; "
                          "the uncertainty is the grid convergence index",
                          t->reference, blank, unit, sure, method, level,
                          isnan(ref->order) ? "the observed" : "the given", c->richardson.order);
    static const char *const why[] = {[STUDY_UNKNOWN] = "as there are fewer than three levels with a size",
                                      [STUDY_MONOTONE] = "as the observed order is below a half",
                                      [STUDY_OSCILLATORY] = "as its finest levels oscillate",
                                      [STUDY_DIVERGENT] = "as its finest levels do not converge",
                                      [STUDY_FLAT] = "as its two finest levels agree to the last digit"};
    return arena_text("%.10g%s%s%s, of %s at %s; not extrapolated, %s; %s", t->reference, blank, unit, sure, method,
                      level, why[c->richardson.kind],
                      *sure ? "the uncertainty is half the range of the finest levels"
                            : "its uncertainty is not known");
}
