/* The results of one rank, for a test to compare with on more ranks. ctest runs the test on one rank first. */
#pragma once
#include "base/par.h"
#include "tests/check.h"

#include <stdio.h>

/* One rank writes value[bytes] to NAME.data and gets a copy of it in expected, more ranks get what one rank wrote. */
static inline void one_rank_expects(const char *name, const void *value, size_t bytes, void *expected) {
    char path[512];
    snprintf(path, sizeof path, FRANA_BINARY_DIR "/%s.data", name);
    FILE *file = fopen(path, par_size() == 1 ? "w+b" : "rb");
    if (!file) fail_msg("%s: run this test on one rank first", path);
    if (par_size() == 1) {
        assert_int_equal(fwrite(value, bytes, 1, file), 1);
        rewind(file);
    }
    assert_int_equal(fread(expected, bytes, 1, file), 1);
    assert_int_equal(fclose(file), 0);
}
