/* Contact ghosts: sends particles to the ranks where they may touch a particle, and updates their displacements there.
 */
#include "solid/contact/ghosts.h"

#include "base/memory.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "solid/contact/reserve.h"

#include <string.h>

void solid_contact_ghosts_send(struct solid_contact_ghosts *x, int h, int rank, const struct solid_contact_ghost *it) {
    const int n = x->sent + 1;
    x->h = solid_contact_reserve(x->h, &x->pack_capacity[0], n, sizeof *x->h);
    x->dest = solid_contact_reserve(x->dest, &x->pack_capacity[1], n, sizeof *x->dest);
    x->local = solid_contact_reserve(x->local, &x->pack_capacity[2], n, sizeof *x->local);
    x->h[x->sent] = h;
    x->dest[x->sent] = rank;
    x->local[x->sent++] = *it;
}

void solid_contact_ghosts_begin(struct solid_contact_ghosts *x) {
    x->exchange = par_exchange_renew(x->exchange, x->sent, NULL, x->dest);
    x->served = par_exchange_count(x->exchange);
    x->sent_d = solid_contact_reserve(x->sent_d, &x->pack_capacity[3], x->sent, sizeof *x->sent_d);
    x->wanted = solid_contact_reserve(x->wanted, &x->sent_capacity, x->sent, 1);
    x->local = solid_contact_reserve(x->local, &x->pack_capacity[2], x->sent, sizeof *x->local);
    const int n = x->served;
    x->other = solid_contact_reserve(x->other, &x->served_capacity[0], n, sizeof *x->other);
    x->arrived = solid_contact_reserve(x->arrived, &x->served_capacity[1], n, sizeof *x->arrived);
    x->used = solid_contact_reserve(x->used, &x->served_capacity[2], n, 1);
    x->at = solid_contact_reserve(x->at, &x->served_capacity[3], n, sizeof *x->at);
    for (int c = 0; c < 3; c++)
        x->d[c] = solid_contact_reserve(x->d[c], &x->served_capacity[4 + c], n, sizeof *x->d[c]);
    memset(x->used, 0, (size_t)n);
    par_exchange_forward(x->exchange, x->local, x->other, sizeof *x->local);
    x->active = par_sum_long(n) > 0;
}

void solid_contact_ghosts_keep(struct solid_contact_ghosts *x) {
    int kept = 0, place = 0;
    par_exchange_backward(x->exchange, x->used, x->wanted, 1);
    for (int k = 0; k < x->sent; k++)
        if (x->wanted[k]) {
            x->h[kept] = x->h[k];
            x->local[kept] = x->local[k];
            x->dest[kept++] = x->dest[k];
        }
    x->sent = kept;
    for (int k = 0; k < x->served; k++) x->at[k] = x->used[k] ? place++ : -1;
    solid_contact_ghosts_begin(x);
}

void solid_contact_ghosts_update(const struct solid *s, struct solid_contact_ghosts *x) {
    for (int k = 0; k < x->sent; k++)
        for (int c = 0; c < s->dim; c++) x->sent_d[k][c] = s->d[c][x->h[k]];
    par_exchange_forward(x->exchange, x->sent_d, x->arrived, sizeof *x->sent_d);
    for (int k = 0; k < x->served; k++)
        for (int c = 0; c < s->dim; c++) x->d[c][k] = x->arrived[k][c];
}

void solid_contact_ghosts_free(struct solid_contact_ghosts *x) {
    MEMORY_FREE(x->h, x->dest, x->local, x->sent_d, x->other, x->arrived, x->d[0], x->d[1], x->d[2], x->used, x->wanted,
                x->at);
    par_exchange_free(x->exchange);
    *x = (struct solid_contact_ghosts){0};
}
