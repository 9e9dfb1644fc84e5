/* List of named quantities with units, and its CSV file. */
#include "postproc/facts.h"
#include "base/files/atomic_write.h"
#include "base/files/csv.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

struct postproc_facts_name postproc_facts_name(const char *format, ...) {
    struct postproc_facts_name name;
    va_list args;
    va_start(args, format);
    vsnprintf(name.text, sizeof name.text, format, args);
    va_end(args);
    return name;
}

void postproc_facts_number(struct postproc_facts *f, const char *quantity, const char *unit, double value) {
    if (isnan(value) || f->n == POSTPROC_FACTS) return;
    struct postproc_fact *fact = &f->fact[f->n++];
    snprintf(fact->quantity, sizeof fact->quantity, "%s", quantity);
    snprintf(fact->unit, sizeof fact->unit, "%s", unit);
    const int whole = value == rint(value) && fabs(value) < 1e9;
    snprintf(fact->text, sizeof fact->text, whole ? "%.0f" : "%.4g", value);
    fact->value = value;
}

void postproc_facts_text(struct postproc_facts *f, const char *quantity, const char *text) {
    if (!text || f->n == POSTPROC_FACTS) return;
    struct postproc_fact *fact = &f->fact[f->n++];
    snprintf(fact->quantity, sizeof fact->quantity, "%s", quantity);
    snprintf(fact->unit, sizeof fact->unit, "%s", "");
    snprintf(fact->text, sizeof fact->text, "%s", text);
    fact->value = NAN;
}

const struct postproc_fact *postproc_facts_find(const struct postproc_facts *f, const char *quantity) {
    for (int i = 0; i < f->n; i++)
        if (strcmp(f->fact[i].quantity, quantity) == 0) return &f->fact[i];
    return NULL;
}

int postproc_facts_write(const struct postproc_facts *f, const char *path) {
    return postproc_facts_write_from(f, 0, path);
}

int postproc_facts_write_from(const struct postproc_facts *f, int first, const char *path) {
    FILE *file = atomic_write_open(path);
    if (!file) return -1;
    fputs("quantity,unit,value\n", file);
    for (int i = first; i < f->n; i++) {
        csv_put(file, f->fact[i].quantity);
        fputc(',', file);
        csv_put(file, f->fact[i].unit);
        fputc(',', file);
        if (isnan(f->fact[i].value))
            csv_put(file, f->fact[i].text);
        else
            fprintf(file, "%.10g", f->fact[i].value);
        fputc('\n', file);
    }
    const int bad = ferror(file);
    return atomic_write_close(file, path, bad);
}
