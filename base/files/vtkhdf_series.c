/* Keeps the index file of a series of VTKHDF files: file names and times. */
#include "base/par.h"
#include "base/files/atomic_write.h"
#include "base/files/vtkhdf.h"
#include "base/files/plain_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Reads only files of the form that write() below makes: {"name": "...", "time": t}, one entry a line. */
int vtkhdf_series_read(const char *series, struct vtkhdf_series_entry **list) {
    FILE *f = plain_file_read(series);
    int n = 0, capacity = 0;
    char *line = NULL;
    size_t bytes = 0;
    *list = NULL;
    if (!f) return -1;
    while (getline(&line, &bytes, f) > 0) {
        struct vtkhdf_series_entry e;
        if (sscanf(line, " { \"name\" : \"%255[^\"]\" , \"time\" : %lf }", e.file, &e.time) != 2) continue;
        if (n == capacity) {
            capacity = 2 * capacity + 16;
            *list = realloc(*list, (size_t)capacity * sizeof **list);
        }
        (*list)[n++] = e;
    }
    free(line);
    fclose(f);
    return n;
}

static void entry(FILE *f, const char *file, double time, int more) {
    fprintf(f, "    {\"name\": \"%s\", \"time\": %.15g}%s\n", file, time, more ? "," : "");
}

/* Writes the entries for which `keep` is true, then one more unless file is NULL. */
static void write(const char *series, const struct vtkhdf_series_entry *list, int n, const char *file, double time) {
    struct atomic_write a;
    atomic_write_begin(&a, series);
    a.unsynced = 1;
    fputs("{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n", a.file);
    for (int k = 0; k < n; k++) entry(a.file, list[k].file, list[k].time, k < n - 1 || file);
    if (file) entry(a.file, file, time, 0);
    fputs("  ]\n}\n", a.file);
    atomic_write_end(&a);
}

void vtkhdf_series_add(const char *series, const char *file, double time) {
    if (par_rank() == 0) {
        struct vtkhdf_series_entry *list;
        const int n = vtkhdf_series_read(series, &list);
        int kept = 0;
        for (int k = 0; k < n; k++)
            if (strcmp(list[k].file, file) != 0) list[kept++] = list[k];
        write(series, list, kept, file, time);
        free(list);
    }
    par_barrier();
}

void vtkhdf_series_cut(const char *series, double time) {
    if (par_rank() == 0) {
        struct vtkhdf_series_entry *list;
        const int n = vtkhdf_series_read(series, &list);
        int kept = 0;
        for (int k = 0; k < n; k++)
            if (list[k].time <= time + 1e-9 * fabs(time)) list[kept++] = list[k];
        if (n >= 0 && kept < n) write(series, list, kept, NULL, 0);
        free(list);
    }
    par_barrier();
}
