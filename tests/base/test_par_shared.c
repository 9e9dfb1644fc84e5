/* Arrays that the ranks of a node share: one copy, unions and copies between nodes, and what happens where memory
 * cannot be shared. */
#include "base/par.h"
#include "base/par_shared.h"
#include "tests/check.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>

enum { WORDS = 3 * (1 << 20) + 5 }; /* several of the pieces that are sent at once, and a remainder */

/* The calls that fail, on the ranks chosen. */
static struct { int memory, space, other; } fails;
int __wrap_memfd_create(const char *name, unsigned flags);
int __real_memfd_create(const char *name, unsigned flags);
int __wrap_memfd_create(const char *name, unsigned flags) {
    if (!fails.memory) return __real_memfd_create(name, flags);
    errno = ENOSYS;
    return -1;
}
int __wrap_posix_fallocate(int file, off_t from, off_t bytes);
int __real_posix_fallocate(int file, off_t from, off_t bytes);
int __wrap_posix_fallocate(int file, off_t from, off_t bytes) {
    return fails.space ? ENOSPC : __real_posix_fallocate(file, from, bytes);
}
int __wrap_stat(const char *path, struct stat *is);
int __real_stat(const char *path, struct stat *is);
int __wrap_stat(const char *path, struct stat *is) { /* the process of this number is another one here */
    return __real_stat(fails.other && strncmp(path, "/proc/", 6) == 0 ? "/proc/self/exe" : path, is);
}

/* What nodes of at most `most` ranks give. */
static int sharers_of(int most) {
    const int size = par_size(), first = par_rank() / most * most;
    return size - first < most ? size - first : most;
}
static int copies_of(int most) { return (par_size() + most - 1) / most; }

static long files_open(void) {
    long n = 0;
    DIR *folder = opendir("/proc/self/fd");
    while (readdir(folder)) n++;
    closedir(folder);
    return n;
}

/* Every rank writes its own words, and reads those of the others that share the copy. */
static void ranks_of_a_node_see_one_copy(void **state) {
    (void)state;
    const int size = par_size(), rank = par_rank();
    for (int most = 1; most <= size; most++) {
        const size_t before = memory_bytes(MEMORY_OUTPUT);
        par_shared_limit(most < size ? most : 0);
        struct par_shared *s = par_shared_new(MEMORY_OUTPUT, WORDS * sizeof(uint64_t));
        assert_int_equal(par_shared_ranks(), sharers_of(most));
        uint64_t *word = s->data;
        const long files = files_open();
        assert_string_equal(s->why, "");
        check_equal(s->bytes, WORDS * sizeof(uint64_t));
        check_equal(s->sharers, sharers_of(most));
        check_equal(s->copies, copies_of(most));
        check_equal(s->is_writer, rank % most == 0);
        check_equal((uintptr_t)s->data % 64, 0);
        check_equal(par_sum_long((long)(memory_bytes(MEMORY_OUTPUT) - before)),
                    (long)(s->bytes * (size_t)s->copies + sizeof *s * (size_t)size));
        for (int w = 0; w < WORDS; w++)
            if (word[w] != 0) fail_msg("word %d is %lx at first", w, word[w]);
        par_shared_fence(s);
        for (int w = rank; w < WORDS; w += size) word[w] = 1000u * (unsigned)w + (unsigned)rank;
        par_shared_fence(s);
        for (int w = 0; w < WORDS; w++) {
            const int from = w % size, here = from / most == rank / most;
            const uint64_t is = here ? 1000u * (unsigned)w + (unsigned)from : 0;
            if (word[w] != is) fail_msg("word %d is %lx, not %lx", w, word[w], is);
        }
        par_shared_free(s);
        check_equal(files_open(), files);
        check_equal(memory_bytes(MEMORY_OUTPUT), before);
    }
    par_shared_limit(0);
}

/* Bits of the same words from all ranks; then rank 0's array on all. */
static void check_exchanged(struct par_shared *s) {
    const int size = par_size(), rank = par_rank();
    uint64_t *word = s->data, all = 0;
    for (int r = 0; r < size; r++) all |= UINT64_C(0x0101010101010101) << r;
    for (int w = 0; w < WORDS; w++) __atomic_fetch_or(&word[w], UINT64_C(0x0101010101010101) << rank, __ATOMIC_RELAXED);
    par_shared_unite(s);
    for (int w = 0; w < WORDS; w++)
        if (word[w] != all) fail_msg("word %d of the union is %lx, not %lx", w, word[w], all);
    par_shared_fence(s);
    if (s->is_writer)
        for (int w = 0; w < WORDS; w++) word[w] = (uint64_t)w * 3 + (unsigned)rank;
    par_shared_spread(s);
    for (int w = 0; w < WORDS; w++)
        if (word[w] != (uint64_t)w * 3) fail_msg("word %d is %lx, not rank 0's", w, word[w]);
}

static void copies_are_united_and_spread(void **state) {
    (void)state;
    for (int most = 1; most <= par_size(); most++) {
        par_shared_limit(most < par_size() ? most : 0);
        struct par_shared *s = par_shared_new(MEMORY_OUTPUT, WORDS * sizeof(uint64_t));
        check_equal(s->copies, copies_of(most));
        check_exchanged(s);
        par_shared_free(s);
    }
    par_shared_limit(0);
}

static void odd_sizes(void **state) {
    (void)state;
    for (size_t bytes = 0; bytes < 20; bytes++) {
        struct par_shared *s = par_shared_new(MEMORY_OUTPUT, bytes);
        check_equal(s->bytes, bytes == 0 ? 8 : (bytes + 7) / 8 * 8);
        if (par_rank() == 0) memset(s->data, 7, s->bytes);
        par_shared_spread(s);
        for (size_t b = 0; b < s->bytes; b++) check_equal(((char *)s->data)[b], 7);
        par_shared_free(s);
    }
}

/* Each rank holds a copy of its own, all say why, and nothing stays open. */
static void check_alone(const char *why) {
    const size_t before = memory_bytes(MEMORY_OUTPUT);
    const long files = files_open();
    struct par_shared *s = par_shared_new(MEMORY_OUTPUT, WORDS * sizeof(uint64_t));
    if (par_size() == 1) why = "";
    if (strlen(why) == 0 ? s->why[0] != '\0' : !strstr(s->why, why)) fail_msg("\"%s\" says not \"%s\"", s->why, why);
    check_equal(files_open(), files);
    check_equal(s->sharers, 1);
    check_equal(s->copies, par_size());
    check_equal(s->is_writer, 1);
    check_equal(memory_bytes(MEMORY_OUTPUT) - before, s->bytes + sizeof *s);
    check_exchanged(s);
    par_shared_free(s);
    check_equal(memory_bytes(MEMORY_OUTPUT), before);
}

static void without_shared_memory(void **state) {
    (void)state;
    const int rank = par_rank(), last = par_size() - 1;
    fails.memory = 1;
    check_alone("memfd_create: Function not implemented");
    fails.memory = 0;
    fails.space = rank == 0;
    check_alone("posix_fallocate: No space left on device");
    fails.space = 0;
    fails.other = rank == last; /* one that does not share is enough */
    check_alone("No such process");
    fails.other = 0;
    if (last > 1) { /* the second node has no room */
        par_shared_limit(2);
        fails.space = rank == 2;
        if (last > 2) check_alone("posix_fallocate: No space left on device");
        fails.space = 0;
        par_shared_limit(0);
    }
}

/* A limit to the size of files neither ends the program nor the array. */
static void limited_files(void **state) {
    (void)state;
    struct rlimit old, small;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &old), 0);
    small = (struct rlimit){1 << 20, old.rlim_max};
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    check_alone("ulimit -f: File too large");
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &old), 0);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(ranks_of_a_node_see_one_copy),
                                       cmocka_unit_test(copies_are_united_and_spread), cmocka_unit_test(odd_sizes),
                                       cmocka_unit_test(without_shared_memory), cmocka_unit_test(limited_files)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
