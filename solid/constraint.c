#include "solid/constraint.h"

static int inside(const struct solid *s, int h, const double low[3], const double high[3]) {
    const double tiny = 1e-9 * s->in.spacing;
    for (int c = 0; c < 3; c++)
        if (s->x0[c][h] < low[c] - tiny || s->x0[c][h] > high[c] + tiny) return 0;
    return 1;
}

double solid_density(const struct solid *s, int h) {
    return s->in.material[s->in.body[s->body[h]].material].density;
}

void solid_constraint_velocity(struct solid *s) {
    for (int q = 0; q < s->in.constraints; q++) {
        const struct solid_constraint *k = &s->in.constraint[q];
        for (int h = 0; h < s->n; h++)
            if (inside(s, h, k->low, k->high))
                for (int c = 0; c < 3; c++)
                    if (k->direction[c]) s->v[c][h] = k->velocity[c];
    }
}

void solid_constraint_mark(struct solid *s) {
    for (int q = 0; q < s->in.constraints; q++) {
        const struct solid_constraint *k = &s->in.constraint[q];
        for (int h = 0; h < s->n; h++)
            if (inside(s, h, k->low, k->high))
                for (int c = 0; c < 3; c++)
                    if (k->direction[c]) s->flag[h] |= (uint8_t)(SOLID_HELD_X << c);
    }
    for (int q = 0; q < s->in.unbreakables; q++)
        for (int h = 0; h < s->n; h++)
            if (inside(s, h, s->in.unbreakable[q].low, s->in.unbreakable[q].high))
                s->flag[h] |= SOLID_UNBREAKABLE;
    solid_constraint_velocity(s);
}

double solid_constraint_apply(struct solid *s) {
    double power = 0, reaction2 = 0;
    for (int h = 0; h < s->n; h++) {
        if (!(s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z))) continue;
        const double mass = solid_density(s, h) * s->volume[h];
        for (int c = 0; c < 3; c++) {
            if (!(s->flag[h] & SOLID_HELD_X << c)) continue;
            const double reaction = -mass * s->a[c][h];
            power += reaction * s->v[c][h];
            reaction2 += reaction * reaction;
            s->a[c][h] = 0;
        }
    }
    s->power_constraint = power;
    return reaction2;
}
