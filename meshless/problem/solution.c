/* Writes solution.csv. */
#include "meshless/problem/solution.h"
#include "base/par.h"
#include "base/files/atomic_write.h"
#include "base/files/csv.h"
#include "base/files/folder.h"

#include <stdio.h>

void meshless_solution_write(int n, const struct meshless_solution_quantity *fact, const char *folder) {
    char path[FOLDER_PATH];
    struct atomic_write a;
    if (par_rank() != 0) return;
    atomic_write_begin(&a, folder_path(path, folder, "solution.csv"));
    fputs("quantity,unit,value\n", a.file);
    for (int k = 0; k < n; k++) {
        csv_put(a.file, fact[k].quantity);
        fputc(',', a.file);
        csv_put(a.file, fact[k].unit);
        fprintf(a.file, ",%.17g\n", fact[k].value);
    }
    atomic_write_end(&a);
}
