#include "solid/family.h"
#include "solid/measures.h"

void solid_measure_damage(const struct solid *s, double *phi) {
    struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        if (!(s->flag[h] & SOLID_BROKEN)) {
            phi[h] = 0;
            continue;
        }
        double intact = 0, all = 0;
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            all += view.weight[b];
            if (view.intact[b]) intact += view.weight[b];
        }
        phi[h] = all > 0 ? 1 - intact / all : 0;
    }
}
