#include "solid/surface_lost.h"

#include "base/memory.h"
#include "solid/family.h"

int solid_lost_take(struct solid *s, enum solid_broke reader) {
    const int news = s->broke & (SOLID_BROKE_NEW | (int)reader);
    if (!news) return 0;
    if (s->broke & SOLID_BROKE_NEW) s->broke = SOLID_BROKE_SURFACE | (s->in.contact ? SOLID_BROKE_CONTACT : 0);
    s->broke &= ~(int)reader;
    return 1;
}

static int count(struct solid_lost *lost, const struct solid *s, int h) {
    solid_family_save(s, h, lost->bits);
    int bonds = 0;
    for (int b = 0; b < lost->bytes; b++) bonds += __builtin_popcount(lost->bits[b]);
    return bonds;
}

struct solid_lost *solid_lost_new(const struct solid *s) {
    struct solid_lost *lost = memory_new(MEMORY_SOLID, 1, sizeof *lost);
    lost->bytes = solid_family_bytes(s);
    lost->bits = memory_new(MEMORY_SOLID, (size_t)lost->bytes + 1, 1);
    lost->intact = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *lost->intact);
    for (int h = 0; h < s->n; h++) lost->intact[h] = (uint16_t)count(lost, s, h);
    return lost;
}

void solid_lost_free(struct solid_lost *lost) {
    if (!lost) return;
    memory_free(lost->bits);
    memory_free(lost->intact);
    memory_free(lost);
}

int solid_lost_since(struct solid_lost *lost, const struct solid *s, int h) {
    const uint16_t now = (uint16_t)count(lost, s, h);
    const int fewer = now != lost->intact[h];
    lost->intact[h] = now;
    return fewer;
}
