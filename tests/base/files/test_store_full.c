/* Writes a checkpoint of a given size; disk_full.py checks what remains when the disk is full. */
/* Writes a checkpoint of about `mebibytes`; disk_full.py checks what remains when the disk is full. usage:
 * test_store_full FOLDER NAME MEBIBYTES [LIMIT_MEBIBYTES [amid]]   the limit is on a file's size, from the start or
 * while the file is written */
#include "base/memory.h"
#include "base/par.h"
#include "base/files/store.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc < 4) return 2;
    const long n = (long)(atof(argv[3]) * (1 << 20) / (4 * 8)), first = n * par_rank() / par_size();
    const long count = n * (par_rank() + 1) / par_size() - first;
    double *value = memory_new(MEMORY_OUTPUT, (size_t)count + 1, sizeof *value);
    for (long i = 0; i < count; i++) value[i] = (double)(first + i);
    const rlim_t most = (rlim_t)(argc > 4 ? atof(argv[4]) * (1 << 20) : 0);
    const struct rlimit limit = {most, most};
    if (argc > 4) signal(SIGXFSZ, SIG_IGN);
    if (argc == 5) setrlimit(RLIMIT_FSIZE, &limit);
    struct store *s = store_begin(argv[1], argv[2], 2);
    for (int k = 0; k < 4; k++) {
        char name[32];
        if (argc > 5 && k == 1) setrlimit(RLIMIT_FSIZE, &limit);
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
