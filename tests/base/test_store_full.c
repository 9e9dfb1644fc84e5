/* Writes a checkpoint of about `mebibytes`; disk_full.py looks at what is left when the disk says no.
 * usage: test_store_full FOLDER NAME MEBIBYTES [LIMIT_MEBIBYTES]   the limit is on a file's size */
#include "base/memory.h"
#include "base/par.h"
#include "base/store.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc < 4) return 2;
    const long n = atol(argv[3]) * (1 << 20) / (4 * 8), first = n * par_rank() / par_size();
    const long count = n * (par_rank() + 1) / par_size() - first;
    double *value = memory_new(MEMORY_OUTPUT, (size_t)count + 1, sizeof *value);
    for (long i = 0; i < count; i++) value[i] = (double)(first + i);
    if (argc > 4) {
        const rlim_t most = (rlim_t)atol(argv[4]) << 20;
        signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &(struct rlimit){most, most});
    }
    struct store *s = store_begin(argv[1], argv[2], 2);
    for (int k = 0; k < 4; k++) {
        char name[32];
        snprintf(name, sizeof name, "array_%d", k);
        store_write_range(s, name, STORE_DOUBLE, 1, n, first, count, value);
    }
    store_write_long(s, "n", n);
    store_end(s);
    memory_free(value);
    if (par_rank() == 0) printf("written\n");
    par_end();
    return 0;
}
