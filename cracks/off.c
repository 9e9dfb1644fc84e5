/* Which struts are off. */
#include "cracks/off.h"

int cracks_off_is(const struct cracks *c, cracks_vec jump) { return cracks_kernel_sum(jump * jump) > c->gap * c->gap; }

void cracks_off_keep(struct cracks *c, int old_n, const int *old_h, const long *old_start, const uint16_t *old_kind) {
    struct cracks_struts *t = &c->struts;
    const int kinds = c->table.kinds;
    for (int i = 0, j = 0; i < t->n; i++) {
        uint8_t was_off[SOLID_FAMILY_MAX] = {0};
        while (j < old_n && old_h[j] < t->h[i]) j++;
        if (j == old_n) return;
        if (old_h[j] != t->h[i]) continue;
        for (long k = old_start[j]; k < old_start[j + 1]; k++)
            if (old_kind[k] >= kinds) was_off[old_kind[k] - kinds] = 1;
        for (long k = t->start[i]; k < t->start[i + 1]; k++)
            if (was_off[t->kind[k]]) t->kind[k] = (uint16_t)(t->kind[k] + kinds);
    }
}
