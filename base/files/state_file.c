/* Writes the items of tables of state to a checkpoint and reads them back. */
#include "base/files/state_file.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"

#include <string.h>

static enum store_type type_of(enum state_kind kind) {
    return kind == STATE_DOUBLE ? STORE_DOUBLE : kind == STATE_BYTE ? STORE_BYTE : STORE_LONG;
}

static struct state_size size_of(const struct state_part *part) {
    struct state_size size = {0};
    part->size(part->owner, &size);
    return size;
}

static void *buffer_new(const struct state_item *item, long n, int comps) {
    return memory_new(MEMORY_OUTPUT, (size_t)n * (size_t)comps + 1, state_item_value_bytes(item->kind));
}

/* The array of an item that is stored unchanged, without a function and with one component; else NULL. */
static void *direct(const struct state_item *item, const struct state_part *part, int comps, int has_function) {
    return !has_function && comps == 1 ? state_item_array(item, part, 0) : NULL;
}

/* The components one after another, particle by particle. */
static void gather(const struct state_item *item, const struct state_part *part, int n, int comps, double *value) {
    ENSURE(item->kind == STATE_DOUBLE, "%s is a vector and not of doubles", item->name);
    for (int c = 0; c < comps; c++) {
        const double *from = state_item_array(item, part, c);
        for (int h = 0; h < n; h++) value[comps * h + c] = from[h];
    }
}

static void scatter(const struct state_item *item, const struct state_part *part, int n, int comps,
                    const double *value) {
    ENSURE(item->kind == STATE_DOUBLE, "%s is a vector and not of doubles", item->name);
    for (int c = 0; c < comps; c++) {
        double *to = state_item_array(item, part, c);
        for (int h = 0; h < n; h++) to[h] = value[comps * h + c];
    }
}

static void write_one(struct store *s, const struct state_item *item, const struct state_part *part) {
    union {
        double number;
        long count;
        int small;
        char text[STATE_TEXT_BYTES];
    } is = {.text = ""};
    if (item->save)
        item->save(part->owner, &is);
    else
        memcpy(&is, state_item_array(item, part, 0), state_item_value_bytes(item->kind));
    switch (item->kind) {
    case STATE_DOUBLE:
        store_write_double(s, item->name, is.number);
        break;
    case STATE_LONG:
        store_write_long(s, item->name, is.count);
        break;
    case STATE_INT:
        store_write_long(s, item->name, is.small);
        break;
    case STATE_TEXT:
        store_write_text(s, item->name, is.text);
        break;
    case STATE_BYTE:
        ENSURE(0, "%s: a single byte is not stored", item->name);
    }
}

static void write_particles(struct store *s, const struct state_item *item, const struct state_part *part) {
    const struct state_size size = size_of(part);
    const int comps = state_item_comps(item, part);
    void *value = direct(item, part, comps, item->save != NULL), *own = NULL;
    if (!value) value = own = buffer_new(item, size.n, comps);
    if (own && item->save) item->save(part->owner, own);
    if (own && !item->save) gather(item, part, size.n, comps, own);
    store_write_range(s, item->name, type_of(item->kind), comps, size.n_global, size.first, size.n, value);
    memory_free(own);
}

/* Of this rank in the file. */
static long rows_of(const struct state_item *item, const struct state_part *part) {
    return item->is_shared && par_rank() > 0 ? 0 : item->rows_of(part->owner);
}

static void write_rows(struct store *s, const struct state_item *item, const struct state_part *part) {
    const long n = rows_of(item, part), all = par_sum_long(n), first = par_sum_before(n);
    const int comps = state_item_comps(item, part);
    void *value = buffer_new(item, n, comps);
    if (n > 0) item->save(part->owner, value);
    store_write_range(s, item->name, type_of(item->kind), comps, all, first, n, value);
    memory_free(value);
}

static void write_item(struct store *s, const struct state_item *item, const struct state_part *part, double sum) {
    const struct state_size size = size_of(part);
    double *array;
    switch (item->shape) {
    case STATE_ONE:
        write_one(s, item, part);
        break;
    case STATE_SHARE:
        store_write_double(s, item->name, sum);
        break;
    case STATE_PARTICLE:
    case STATE_SET:
        write_particles(s, item, part);
        break;
    case STATE_ROWS:
        write_rows(s, item, part);
        break;
    case STATE_CELL:
        array = state_item_array(item, part, 0);
        store_write_block(s, item->name, &size.block, array + size.inner);
        break;
    }
}

void state_file_write(struct store *s, const struct state_list *list) {
    double share[STATE_LIST_MAX];
    int shares = 0;
    for (int k = 0; k < list->n; k++)
        if (list->at[k].item->shape == STATE_SHARE)
            share[shares++] = *(double *)state_item_array(list->at[k].item, list->at[k].part, 0);
    if (shares > 0) par_sum_array(share, shares);
    shares = 0;
    for (int k = 0; k < list->n; k++)
        if (list->at[k].item->shape == STATE_SHARE)
            *(double *)state_item_array(list->at[k].item, list->at[k].part, 0) = (par_rank() == 0) * share[shares++];
    shares = 0;
    for (int k = 0; k < list->n; k++) {
        const struct state_item *item = list->at[k].item;
        const double sum = item->shape == STATE_SHARE ? share[shares++] : 0;
        if (item->in & STATE_CHECKPOINT) write_item(s, item, list->at[k].part, sum);
    }
}

static double bytes_of(const struct state_item *item, const struct state_part *part) {
    const struct state_size size = size_of(part);
    const double each = type_of(item->kind) == STORE_BYTE ? 1 : 8;
    const int *n = size.block.n;
    switch (item->shape) {
    case STATE_ONE:
    case STATE_SHARE:
        return each;
    case STATE_PARTICLE:
    case STATE_SET:
        return each * state_item_comps(item, part) * (double)size.n_global;
    case STATE_ROWS:
        return each * state_item_comps(item, part) * (double)par_sum_long(rows_of(item, part));
    case STATE_CELL:
        return each * n[0] * n[1] * n[2];
    }
    return 0;
}

double state_file_bytes(const struct state_list *list) {
    double sum = 0;
    for (int k = 0; k < list->n; k++)
        if (list->at[k].item->in & STATE_CHECKPOINT) sum += bytes_of(list->at[k].item, list->at[k].part);
    return sum;
}

/* Handles an item that the checkpoint does not have. Returns 1 if it may be missing; its default is then set. */
static int is_left_out(const struct state_item *item, const struct state_part *part, long count, long wanted) {
    if (item->missing == STATE_FAULT || count == wanted) return 0;
    if (item->missing == STATE_ZERO) memset(state_item_array(item, part, 0), 0, state_item_value_bytes(item->kind));
    return 1;
}

static int read_one(struct store *s, const struct state_item *item, const struct state_part *part, char *why,
                    size_t capacity) {
    double number;
    long count;
    int small, bad;
    char text[STATE_TEXT_BYTES];
    const void *value = &number;
    if (item->kind == STATE_DOUBLE) {
        bad = store_read_double(s, item->name, &number);
    } else if (item->kind == STATE_TEXT) {
        bad = store_read_text(s, item->name, text, sizeof text);
        value = text;
    } else {
        bad = store_read_long(s, item->name, &count);
        small = bad ? 0 : (int)count;
        value = item->kind == STATE_LONG ? (const void *)&count : (const void *)&small;
    }
    if (bad) return !is_left_out(item, part, 0, 1);
    if (item->load) return item->load(part->owner, value, why, capacity);
    if (item->shape == STATE_SHARE)
        *(double *)state_item_array(item, part, 0) = (par_rank() == 0) * number;
    else
        memcpy(state_item_array(item, part, 0), value, state_item_value_bytes(item->kind));
    return 0;
}

static int read_particles(struct store *s, const struct state_item *item, const struct state_part *part, char *why,
                          size_t capacity) {
    const struct state_size size = size_of(part);
    const int comps = state_item_comps(item, part);
    if (item->missing != STATE_FAULT && is_left_out(item, part, store_read_count(s, item->name), size.n_global))
        return 0;
    void *value = direct(item, part, comps, item->load != NULL), *own = NULL;
    if (!value) value = own = buffer_new(item, size.n, comps);
    int bad = store_read_range(s, item->name, type_of(item->kind), comps, size.n_global, size.first, size.n, value);
    if (!bad && item->load) bad = item->load(part->owner, own, why, capacity);
    if (!bad && own && !item->load) scatter(item, part, size.n, comps, own);
    memory_free(own);
    return bad;
}

static int read_rows(struct store *s, const struct state_item *item, const struct state_part *part) {
    const long n = store_read_count(s, item->name);
    const int comps = state_item_comps(item, part);
    if (n < 0) return item->missing == STATE_FAULT;
    void *value = buffer_new(item, n, comps);
    const int bad = store_read_range(s, item->name, type_of(item->kind), comps, n, 0, n, value) ||
                    item->load_rows(part->owner, n, value);
    memory_free(value);
    return bad;
}

static int read_item(struct store *s, const struct state_item *item, const struct state_part *part, char *why,
                     size_t capacity) {
    const struct state_size size = size_of(part);
    double *array;
    switch (item->shape) {
    case STATE_ONE:
    case STATE_SHARE:
        return read_one(s, item, part, why, capacity);
    case STATE_PARTICLE:
    case STATE_SET:
        return read_particles(s, item, part, why, capacity);
    case STATE_ROWS:
        return read_rows(s, item, part);
    case STATE_CELL:
        array = state_item_array(item, part, 0);
        if (item->missing == STATE_ABOVE && store_read_count(s, item->name) < 0) {
            memcpy(array, state_item_array(item - 1, part, 0), size.cells * sizeof *array);
            return 0;
        }
        return store_read_block(s, item->name, &size.block, array + size.inner);
    }
    return 1;
}

/* Reads the items first .. end-1, which define the particles. */
static int read_set(struct store *s, const struct state_list *list, int first, int end) {
    const struct state_part *part = list->at[first].part;
    void *value[8] = {NULL};
    long n = 0;
    int bad = 0;
    ENSURE(end - first <= 8, "a set of %d items", end - first);
    for (int k = first; k < end && n >= 0; k++) n = store_read_count(s, list->at[k].item->name);
    if (n < 0) return 0; /* a scene whose particles do not change: those of the start */
    for (int k = first; k < end && !bad; k++) {
        const struct state_item *item = list->at[k].item;
        const int comps = state_item_comps(item, part);
        value[k - first] = buffer_new(item, n, comps);
        bad = store_read_range(s, item->name, type_of(item->kind), comps, n, 0, n, value[k - first]);
    }
    bad = bad || part->make(part->owner, n, value);
    for (int k = first; k < end; k++) memory_free(value[k - first]);
    return bad;
}

/* Reads the items marked `last`, or the others. */
static int read_items(struct store *s, const struct state_list *list, int last, int *head, char *why, size_t size) {
    for (int k = 0, end; k < list->n; k = end) {
        const struct state_item *item = list->at[k].item;
        int bad = 0;
        for (end = k + 1; item->shape == STATE_SET && end < list->n && list->at[end].item->shape == STATE_SET;) end++;
        if (!(item->in & STATE_CHECKPOINT) || item->last != last) continue;
        if (item->shape == STATE_SET)
            bad = read_set(s, list, k, end);
        else
            bad = read_item(s, item, list->at[k].part, why, size);
        *head = item->shape == STATE_ONE;
        if (bad) return 1;
    }
    return 0;
}

int state_file_read(struct store *s, const struct state_list *list, int *head, char *why, size_t size) {
    why[0] = '\0';
    if (read_items(s, list, 0, head, why, size)) return 1;
    for (int p = 0; p < list->parts; p++)
        if (list->part[p].settle) list->part[p].settle(list->part[p].owner);
    return read_items(s, list, 1, head, why, size);
}
