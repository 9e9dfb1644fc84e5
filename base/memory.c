/* Aligned allocation of arrays, counted by part of the program. */
#include "base/memory.h"
#include "base/die.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>

/* Large arrays start at different offsets from a huge page's start: arrays with equal alignment would map equal indices
 * to one set of an eight-way cache. The offset grows by 197 cache lines an array and repeats after 11 arrays: 11 x
 * 197 lines is about 128 KB, after which the sets of a second-level cache repeat. */
enum { ALIGNMENT = 64, HUGE_PAGE = 2 << 20, STAGGER = 197 * ALIGNMENT, TURNS = 11 };

struct header {
    size_t bytes;
    void *start;
    enum memory_part part;
};

static size_t held[MEMORY_PARTS], most[MEMORY_PARTS];

static void take(enum memory_part part, size_t bytes) {
    held[part] += bytes;
    most[part] = held[part] > most[part] ? held[part] : most[part];
}

void *memory_new(enum memory_part part, size_t count, size_t size) {
    static size_t large;
    const size_t bytes = count * size, is_large = bytes >= HUGE_PAGE / 2;
    const size_t shift = is_large ? large++ % TURNS * STAGGER : 0, whole = bytes + shift + 2 * ALIGNMENT;
    void *start = NULL;
    if ((size != 0 && count > (size_t)-1 / 4 / size) || posix_memalign(&start, is_large ? HUGE_PAGE : ALIGNMENT, whole))
        die(EXIT_CODE_FILE, "no memory left for %zu x %zu bytes of the %s", count, size, memory_name(part));
    if (is_large) madvise(start, whole, MADV_HUGEPAGE);
    memset(start, 0, whole);
    char *data = (char *)start + shift + ALIGNMENT;
    *(struct header *)(void *)(data - sizeof(struct header)) = (struct header){bytes, start, part};
    take(part, bytes);
    return data;
}

double *memory_new_work(enum memory_part part, size_t count) {
    double *work = memory_new(part, count, sizeof *work);
#ifdef FRANA_DEBUG
    for (size_t i = 0; i < count; i++) work[i] = NAN;
#endif
    return work;
}

void memory_free(void *p) {
    if (!p) return;
    const struct header *h = (const struct header *)(const void *)((char *)p - sizeof(struct header));
    held[h->part] -= h->bytes;
    free(h->start);
}

void memory_free_all(void *const *list, size_t n) {
    for (size_t i = 0; i < n; i++) memory_free(list[i]);
}

void *memory_copy(enum memory_part part, const void *from, size_t n, size_t size) {
    void *to = memory_new(part, n + 1, size);
    if (n > 0) memcpy(to, from, n * size);
    return to;
}

void *memory_grown(enum memory_part part, void *old, size_t used, size_t capacity, size_t size) {
    void *more = memory_new(part, capacity, size);
    if (old && used > 0) memcpy(more, old, used * size);
    memory_free(old);
    return more;
}

void *memory_renew(enum memory_part part, void *old, size_t capacity, size_t size) {
    memory_free(old);
    return memory_new(part, capacity, size);
}

void memory_count(enum memory_part part, long bytes) { take(part, (size_t)bytes); }

size_t memory_bytes(enum memory_part part) { return held[part]; }

size_t memory_high_water(enum memory_part part) {
    const size_t before = most[part];
    most[part] = held[part];
    return before;
}

size_t memory_peak(void) {
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return (size_t)usage.ru_maxrss * 1024;
}

const char *memory_name(enum memory_part part) {
    static const char *const name[MEMORY_PARTS] = {"fluid", "solid", "ibm", "coupling", "output"};
    return name[part];
}
