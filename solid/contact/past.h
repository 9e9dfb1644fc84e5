/* Accelerations by contact in the last substep, from which the next one's iteration starts. They are not state: without
 * them the iteration takes longer and ends within the same tolerance. For solid/ only. */
#pragma once

struct solid_contact_pushed {
    int particle;           /* an owned one that contact pushed */
    double a[3], coming[3]; /* its acceleration by contact, and the one expected in the next substep, m/s2 */
};

struct solid_contact_past {
    int n, room;
    struct solid_contact_pushed *of; /* [n] */
    double missed; /* the furthest that a particle ended from where it was expected, m; 0: there was no substep */
};

void solid_contact_past_copy(struct solid_contact_past *to, const struct solid_contact_past *from);
