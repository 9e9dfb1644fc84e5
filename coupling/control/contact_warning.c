/* Finds bodies that are within each other's contact radius at the start, or that approach each other too fast. */
#include "coupling/control/contact_warning.h"
#include "coupling/run.h"
#include "solid/contact/passing.h"

#include <math.h>
#include <stdio.h>

static int is_pushed_apart(struct run *r, char *sentence) {
    const struct solid_contact_overlap m = solid_contact_passing_overlap(r->solid);
    const double radius = r->solid->in.contact_radius, spacing = r->solid->in.spacing;
    if (!(m.pairs > 0)) return 0;
    snprintf(
        sentence, CONTACT_WARNING_SENTENCE,
        "%.0f pairs of particles of different bodies are closer than the contact radius of %.4g m, the closest %.4g m "
        "apart: contact pushes them apart, with %.3g J, as soon as the solid moves. With solid.contact.radius: %.4g "
        "they stay at rest",
        m.pairs, radius * spacing, m.least, m.potential, floor(1e4 * m.least / spacing) / 1e4);
    return 1;
}

/* The largest relative velocity that the scene gives two bodies, m/s. */
static double closing(const struct solid_input *in, int *a, int *b) {
    double most = 0;
    for (int i = 0; i < in->bodies; i++)
        for (int k = 0; k < i; k++) {
            double v2 = 0;
            for (int c = 0; c < 3; c++) v2 += pow(in->body[i].velocity[c] - in->body[k].velocity[c], 2);
            if (!(v2 > most)) continue;
            most = v2;
            *a = i, *b = k;
        }
    return sqrt(most);
}

static int is_too_fast(const struct run *r, char *sentence) {
    int a = 0, b = 0;
    const double v = closing(&r->solid->in, &a, &b), held = solid_contact_passing_held_speed(r->solid);
    if (!(v > held)) return 0;
    snprintf(sentence, CONTACT_WARNING_SENTENCE,
             "bodies %s and %s have velocities that differ by %.4g m/s: if they collide, contact stops a pair of "
             "particles up to %.3g "
             "m/s, and faster ones pass through one another. This speed grows with the square root of "
             "solid.contact.stiffness (now %.3g)",
             r->solid->in.body[b].name, r->solid->in.body[a].name, v, held, r->solid->in.contact_stiffness);
    return 1;
}

int contact_warning_of(struct run *r, char sentence[CONTACT_WARNING_MAX][CONTACT_WARNING_SENTENCE]) {
    int n = 0;
    if (!r->needs.contact || r->solid->in.bodies < 2) return 0;
    n += is_pushed_apart(r, sentence[n]);
    n += is_too_fast(r, sentence[n]);
    return n;
}
