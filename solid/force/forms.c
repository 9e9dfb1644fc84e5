/* Keeps what force sweeps remember of each bond's form, while other sweeps are made in between. */
#include "solid/force/forms.h"
#include "base/memory.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/segments.h"

#include <string.h>

struct part {
    void *at; /* borrowed */
    size_t bytes;
};
enum { PARTS = 3 };
struct solid_forms {
    char *kept; /* all parts, one after another */
};

/* What a sweep of body b remembers. Unused parts have no bytes. */
static void parts_of(const struct solid_family *f, int b, struct part part[PARTS]) {
    memset(part, 0, PARTS * sizeof *part);
    if (f->lattice[b]) {
        const struct solid_segments *all = f->lattice[b]->segments;
        part[0] = (struct part){all->large, (size_t)all->n};
        part[1] = (struct part){all->high, (size_t)all->n * sizeof *all->high};
        return;
    }
    const struct solid_list *list = f->list[b];
    const size_t n = (size_t)list->n;
    part[0] = (struct part){list->large, n};
    part[1] = (struct part){list->power, n * sizeof(double)};
    if (list->extension_power) part[2] = (struct part){list->extension_power, n * sizeof(double)};
}

/* Copies all parts to `kept`, or back; returns their bytes. kept NULL: only counts. */
static size_t copy(const struct solid_family *f, char *kept, int back) {
    size_t sum = 0;
    for (int b = 0; b < f->bodies; b++) {
        struct part part[PARTS];
        parts_of(f, b, part);
        for (int k = 0; k < PARTS; k++) {
            if (kept && part[k].bytes > 0)
                memcpy(back ? part[k].at : kept + sum, back ? kept + sum : part[k].at, part[k].bytes);
            sum += part[k].bytes;
        }
    }
    return sum;
}

struct solid_forms *solid_forms_save(const struct solid *s) {
    struct solid_forms *forms = memory_new(MEMORY_SOLID, 1, sizeof *forms);
    forms->kept = memory_new(MEMORY_SOLID, copy(s->family, NULL, 0) + 1, 1);
    copy(s->family, forms->kept, 0);
    return forms;
}

void solid_forms_restore(struct solid *s, struct solid_forms *forms) {
    copy(s->family, forms->kept, 1);
    MEMORY_FREE(forms->kept, forms);
}
