/* The limit of memory of control groups, versions 1 and 2, and of the groups above. */
#include "base/machine.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/frana_machine_XXXXXX";

static void put(const char *name, const char *text) {
    char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static void make(const char *name) {
    char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    assert_int_equal(mkdir(path, 0700), 0);
}

static size_t limit(void) {
    char groups[256];
    snprintf(groups, sizeof groups, "%s/groups", folder);
    return machine_memory_limit(groups, folder);
}

static int begin(void **state) {
    (void)state;
    return mkdtemp(folder) ? 0 : 1;
}

static int end(void **state) {
    (void)state;
    char command[300];
    snprintf(command, sizeof command, "rm -r %s", folder);
    return system(command);
}

static void version_2(void **state) {
    (void)state;
    assert_true(limit() == SIZE_MAX); /* no such file */
    put("groups", "0::/job_1/step_0\n");
    assert_true(limit() == SIZE_MAX); /* as in a container that does not see its group */
    make("job_1");
    make("job_1/step_0");
    put("job_1/step_0/memory.max", "max\n");
    assert_true(limit() == SIZE_MAX);
    put("job_1/memory.max", "3000000000\n"); /* of the job, above the step */
    assert_true(limit() == 3000000000u);
    put("job_1/step_0/memory.max", "2000000000\n");
    assert_true(limit() == 2000000000u);
    put("memory.max", "1000000000\n"); /* the container's own, mounted at the top */
    assert_true(limit() == 1000000000u);
}

static void version_1(void **state) {
    (void)state;
    put("memory.max", "max\n");
    put("job_1/memory.max", "7\n"); /* another hierarchy's */
    put("groups", "4:cpuset:/job_1\n3:cpu,memory,pids:/slurm/job_2\n2:hugememory:/job_1\n");
    make("memory");
    assert_true(limit() == SIZE_MAX);
    put("memory/memory.limit_in_bytes", "9223372036854771712\n");
    make("memory/slurm");
    make("memory/slurm/job_2");
    put("memory/slurm/job_2/memory.limit_in_bytes", "500000000\n");
    assert_true(limit() == 500000000u);
    put("groups", "broken\n:\n\n");
    assert_true(limit() == SIZE_MAX);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(version_2),
        cmocka_unit_test(version_1),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
