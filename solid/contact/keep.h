/* Contact as part of a kept state (solid/keep.h). Inside the room only.
 *
 * Lists that somebody keeps are put away, and not overwritten, when new ones are made; what a bond's breaking has
 * appended to them is cut off again. So keeping costs nothing where the record of torn bonds has not grown. */
#pragma once
#include "solid/contact/list.h"

struct solid_lost;

struct solid_contact_keep {
    int exists;                           /* there was contact */
    struct solid_contact_put_away *lists; /* NULL: none is kept */
    int pairs[SOLID_CONTACT_KINDS], any, torn;
    long record;
    uint8_t *known;          /* [s->n][bytes], NULL: not yet */
    struct solid_lost *lost; /* as the contact last looked; NULL: not yet */
};

/* Not collective. */
void solid_contact_keep_take(struct solid_contact_keep *k, struct solid *s);
void solid_contact_keep_restore(struct solid_contact_keep *k, struct solid *s);
void solid_contact_keep_free(struct solid_contact_keep *k);
