/* Exchange of values of the listed particles that other ranks own. */
#include "solid/contact/remote.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "solid/contact/ends.h"
#include "solid/contact/room.h"

static int owner_of(const struct solid *s, long id) {
    int low = 0, high = par_size() - 1;
    while (low < high) {
        const int middle = (low + high + 1) / 2;
        if (s->first[middle] <= id)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

static void ask(const struct solid *s, const struct solid_contact *c, struct solid_contact_remote *r) {
    const struct solid_contact_ends *t = c->ends;
    r->asked = 0;
    for (int k = 0; k < t->n; k++) {
        const int h = t->end[k].particle, n = r->asked + 1;
        if (h >= 0 && h < s->n) continue;
        r->ask = solid_contact_room(r->ask, &r->room_ask, n, sizeof *r->ask);
        r->dest = solid_contact_room(r->dest, &r->room_dest, n, sizeof *r->dest);
        r->id = solid_contact_room(r->id, &r->room_id, n, sizeof *r->id);
        r->ask[r->asked] = k;
        r->id[r->asked] =
            h < 0 ? c->crossing.other[SOLID_CONTACT_SERVED_END - h].id : solid_contact_strangers_id(c->strangers, h);
        r->dest[r->asked] = owner_of(s, r->id[r->asked]);
        r->asked++;
    }
}

void solid_contact_remote_renew(const struct solid *s, struct solid_contact *c, struct solid_contact_remote *r) {
    if (r->listing == c->listing) return;
    r->listing = c->listing;
    ask(s, c, r);
    r->exchange = par_exchange_renew(r->exchange, r->asked, NULL, r->dest);
    r->served = par_exchange_count(r->exchange);
    const int n = r->asked + r->served;
    r->id = solid_contact_room(r->id, &r->room_id, n + 1, sizeof *r->id);
    r->serve = solid_contact_room(r->serve, &r->room_serve, r->served, sizeof *r->serve);
    r->out = solid_contact_room(r->out, &r->room_out, SOLID_CONTACT_REMOTE_DOUBLES * r->served, sizeof *r->out);
    r->in = solid_contact_room(r->in, &r->room_in, SOLID_CONTACT_REMOTE_DOUBLES * r->asked, sizeof *r->in);
    par_exchange_forward(r->exchange, r->id, r->id + r->asked, sizeof *r->id);
    for (int k = 0; k < r->served; k++)
        r->serve[k] = solid_contact_ends_of(s, c->ends, (int)(r->id[r->asked + k] - s->first[par_rank()]));
    r->any = par_sum_long(r->asked) > 0;
}

void solid_contact_remote_update(struct solid_contact_remote *r, int doubles) {
    if (r->any) par_exchange_backward(r->exchange, r->out, r->in, (size_t)doubles * sizeof(double));
}

void solid_contact_remote_free(struct solid_contact_remote *r) {
    void *const list[] = {r->ask, r->serve, r->out, r->in, r->dest, r->id};
    for (size_t k = 0; k < sizeof list / sizeof list[0]; k++) memory_free(list[k]);
    par_exchange_free(r->exchange);
    *r = (struct solid_contact_remote){0};
}
