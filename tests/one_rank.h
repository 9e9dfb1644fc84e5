/* The results of one rank and thread, for a test to compare with on more of them. ctest runs the test on one rank
 * first. */
#pragma once
#include "base/par.h"
#include "base/threads.h"
#include "tests/check.h"

#include <stdio.h>

/* One rank with one thread writes value[bytes] to NAME.data and gets a copy of it in expected; more ranks or threads
 * get what it wrote. */
static inline void one_rank_expects(const char *name, const void *value, size_t bytes, void *expected) {
    char path[512];
    snprintf(path, sizeof path, FRANA_BINARY_DIR "/%s.data", name);
    const int is_one = par_size() == 1 && threads_count() == 1;
    FILE *file = fopen(path, is_one ? "w+b" : "rb");
    if (!file) fail_msg("%s: run this test on one rank first", path);
    if (is_one) {
        assert_int_equal(fwrite(value, bytes, 1, file), 1);
        rewind(file);
    }
    assert_int_equal(fread(expected, bytes, 1, file), 1);
    assert_int_equal(fclose(file), 0);
}
