/* A number for each variable of a run's state, to see whether it has changed. */
#pragma once
#include "base/files/seal.h"
#include "tests/coupling/state_fill.h"

/* A number for what an item holds over all ranks, whatever their shares of the particles. local: also of the ghosts. */
static uint64_t print_of(struct run *r, const struct state_item *item, const struct state_part *part, int local) {
    const struct state_size size = size_of(part);
    const struct special *is = special_of(item);
    const size_t value = state_item_value_bytes(item->kind);
    uint64_t sum = 0;
    if (is && is->read) {
        char *bytes = calloc(1 << 20, 1);
        const size_t n = is->read(r, bytes);
        sum = seal_sum(bytes, n, 1, 0);
        free(bytes);
    } else if (item->save) {
        const size_t row = item->shape == STATE_ONE ? value : value * (size_t)state_item_comps(item, part);
        const size_t n = item->shape == STATE_ONE ? par_rank() == 0 : (size_t)size.n;
        char *bytes = calloc(n * row + STATE_TEXT_BYTES, 1);
        item->save(part->owner, bytes);
        sum = seal_sum(bytes, n, row, (uint64_t)size.first);
        free(bytes);
    } else if (item->shape == STATE_SHARE && !local) {
        const double all = par_sum(*(double *)state_item_array(item, part, 0));
        sum = seal_sum(&all, par_rank() == 0, sizeof all, 0);
    } else if (item->shape == STATE_ONE || item->shape == STATE_SHARE) {
        sum = seal_sum(state_item_array(item, part, 0), 1, item->bytes, (uint64_t)par_rank());
    } else if (item->shape == STATE_CELL && !local) {
        const struct store_block *b = &size.block;
        const char *array = state_item_array(item, part, 0);
        for (int k = 0; k < b->m[2]; k++)
            for (int j = 0; j < b->m[1]; j++)
                sum += seal_sum(array + value * (size_t)(size.inner + k * b->plane + j * b->row), (size_t)b->m[0],
                                value, (uint64_t)(1000 * (b->lo[2] + k) + 100000 * (b->lo[1] + j)));
    } else {
        const int is_particle = item->shape == STATE_PARTICLE || item->shape == STATE_SET;
        const int comps = state_item_comps(item, part);
        const size_t n = is_particle && !local ? (size_t)size.n : values_of(item, &size);
        for (int c = 0; c < comps; c++)
            sum += seal_sum(state_item_array(item, part, c), n, value,
                            (uint64_t)(1000000 * c + (is_particle ? size.first : 0)));
    }
    return (uint64_t)par_sum_long((long)sum);
}

struct prints {
    int n;
    const char *name[STATE_LIST_MAX];
    uint64_t print[STATE_LIST_MAX];
};

static struct prints prints_of(struct run *r, int local) {
    struct run_state state;
    struct prints p = {0};
    run_state_of(r, &state);
    for (int k = 0; k < state.list.n; k++, p.n++) {
        p.name[k] = state.list.at[k].item->name;
        p.print[k] = print_of(r, state.list.at[k].item, state.list.at[k].part, local);
    }
    return p;
}
