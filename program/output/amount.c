/* Counts the samples, files of fields and checkpoints of a run, and their bytes. */
#include "program/output/amount.h"
#include "program/output/checkpoint.h"

/* Steps from + 1 .. to that are multiples of every. */
static long multiples(long every, long from, long to) { return every > 0 ? to / every - from / every : 0; }

/* Ends of stages within the steps from + 1 .. to, but for those at a multiple of every. */
static long ends(const struct run *r, long every, long from, long to) {
    long end = 0, n = 0;
    for (int k = 0; k < r->scene->stages; k++) {
        end += r->scene->stage[k].steps;
        n += r->scene->stage[k].steps > 0 && end > from && end <= to && (every <= 0 || end % every != 0);
    }
    return n;
}

long amount_samples(const struct run *r, long every, long from, long to) {
    return every > 0 ? multiples(every, from, to) + ends(r, every, from, to) : 0;
}

static long all_steps(const struct run *r) {
    long steps = 0;
    for (int k = 0; k < r->scene->stages; k++) steps += r->scene->stage[k].steps;
    return steps;
}

long amount_fields(const struct run *r) { return amount_samples(r, r->scene->output.fields_every, 0, all_steps(r)); }

/* 4 bytes a number, 8 an id, 17 a vertex (program/output/fields.c). */
double amount_fields_bytes(const struct run *r) {
    const int *n = r->scene->domain.cells;
    const double cells = r->fluid ? (double)n[0] * n[1] * n[2] : 0;
    const double particles = r->solid ? (double)r->solid->n_global : 0;
    const int each = (!r->needs.bonds ? 40 : r->scene->output.stress ? 172 : 100) + (r->fluid ? 0 : 12);
    return cells * 4 * (r->medium ? 5 : 4) + particles * each;
}

/* A stage's end has a checkpoint of its own, beside that of the step. */
double amount_bytes(struct run *r, long from, long to) {
    const struct scene_output *out = &r->scene->output;
    const double checkpoints = (double)(multiples(out->checkpoint_every, from, to) + ends(r, 0, from, to));
    return (double)amount_samples(r, out->fields_every, from, to) * amount_fields_bytes(r) +
           checkpoints * checkpoint_bytes(r);
}
