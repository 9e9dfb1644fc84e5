/* An array of more than 2^31 bytes on two nodes: its union, and rank 0's copy on both. Takes 4.4 GB. */
#include "base/par.h"
#include "base/par_shared.h"
#include "tests/check.h"

static const size_t WORDS = ((size_t)1 << 28) + (1 << 21) + 3;

static void more_than_an_int_of_bytes(void **state) {
    (void)state;
    const size_t rank = (size_t)par_rank(), size = (size_t)par_size();
    par_shared_limit(1);
    struct par_shared *s = par_shared_new(MEMORY_OUTPUT, WORDS * sizeof(uint64_t));
    uint64_t *word = s->data;
    check_equal(s->copies, size);
    for (size_t w = rank; w < WORDS; w += size) word[w] = w + 1;
    par_shared_unite(s);
    for (size_t w = 0; w < WORDS; w++)
        if (word[w] != w + 1) fail_msg("word %zu of the union is %lx", w, word[w]);
    if (rank == 0)
        for (size_t w = 0; w < WORDS; w++) word[w] = ~w;
    par_shared_spread(s);
    for (size_t w = 0; w < WORDS; w++)
        if (word[w] != ~w) fail_msg("word %zu is %lx, not rank 0's", w, word[w]);
    par_shared_free(s);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(more_than_an_int_of_bytes)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
