/* The program of a room's tests: runs the files that its arguments name in one process (tools/cmake/test.cmake). */
#include "base/par.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

struct test {
    const char *name;
    int (*run)(int argc, char **argv);
};
#include TESTS_OF_THE_ROOM

/* What the files call in the place of par_begin and par_end: MPI can be started once only. */
void together_begin(int *argc, char ***argv);
void together_end(void);

static int has_begun;

void together_begin(int *argc, char ***argv) {
    if (!has_begun) par_begin(argc, argv);
    has_begun = 1;
}

void together_end(void) {}

static void list(void) {
    for (size_t k = 0; k < sizeof all_tests / sizeof *all_tests; k++) fprintf(stderr, "    %s\n", all_tests[k].name);
    exit(2);
}

static const struct test *find(const char *name) {
    for (size_t k = 0; k < sizeof all_tests / sizeof *all_tests; k++)
        if (!strcmp(all_tests[k].name, name)) return &all_tests[k];
    fprintf(stderr, "there is no %s; there are:\n", name);
    list();
    return NULL;
}

static double cpu_seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

/* Each file gets its name alone. Returns whether one of them failed. */
int main(int argc, char **argv) {
    int failed = 0;
    if (argc < 2) {
        fprintf(stderr, "usage: [mpiexec -n RANKS] %s NAME...; names of test files:\n", argv[0]);
        list();
    }
    for (int k = 1; k < argc; k++) {
        char *one[] = {argv[k], NULL}, **given = one;
        const struct test *test = find(argv[k]);
        fflush(stderr);
        printf("======== %s\n", test->name);
        fflush(stdout);
        double begun = cpu_seconds();
        int code = test->run(1, given);
        printf("-------- %s: %.2f s of this rank's CPU\n", test->name, cpu_seconds() - begun);
        if (code == 0) continue;
        printf("FAILED: %s\n", test->name);
        failed = 1;
    }
    if (has_begun) par_end();
    return failed;
}
