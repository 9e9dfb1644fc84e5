/* Writes a series of given length; disk_full.py checks what remains when the disk is full. */
/* Writes a series of so many rows with a column of the given name; disk_full.py checks what remains when it cannot.
 * usage: test_table_full FOLDER COLUMN RESUME_STEP ROWS [LIMIT_BYTES]   the limit is on a file's size */
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/table.h"

#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc < 5) return 2;
    if (argc > 5) {
        const rlim_t most = (rlim_t)atol(argv[5]);
        signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &(struct rlimit){most, most});
    }
    char path[FOLDER_PATH];
    const char *const name[] = {"step", argv[2]}, *const unit[] = {"1", "Pa"};
    const long resume = atol(argv[3]);
    struct table *t = table_new(folder_path(path, argv[1], "series.csv"), 2, name, unit, resume);
    for (long k = 1; k <= atol(argv[4]); k++) table_row(t, (double[]){(double)((resume < 0 ? 0 : resume) + k), 0.5});
    table_free(t);
    par_end();
    return 0;
}
