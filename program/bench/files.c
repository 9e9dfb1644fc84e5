/* Reads the measured files of several machines. */
#include "program/bench/files.h"
#include "base/die.h"
#include "base/files/read_file.h"

#include <stdio.h>
#include <string.h>

static int is_run(const char *path) {
    const size_t length = strlen(path);
    return length > 5 && !strcmp(path + length - 5, ".json");
}

/* The machine whose folder holds the path: directly, or deepest in one of its own folders. NULL: none does. */
static struct bench_results *machine_of(struct bench_files *f, const char *path, int directly) {
    struct bench_results *found = NULL;
    const size_t folder = strrchr(path, '/') ? (size_t)(strrchr(path, '/') - path) : 0;
    for (int k = 0; k < f->machines; k++) {
        const size_t length = strlen(f->machine[k].folder);
        if (strncmp(path, f->machine[k].folder, length) != 0 || length > folder) continue;
        if (directly ? length != folder : length > 0 && path[length] != '/') continue;
        if (!found || length > strlen(found->folder)) found = &f->machine[k];
    }
    return found;
}

static struct bench_results *add_machine(struct bench_files *f, const char *path) {
    if (f->machines == BENCH_MACHINES_MAX)
        die(EXIT_CODE_FILE, "%s: is of more than %d machines, which are folders", path, BENCH_MACHINES_MAX);
    struct bench_results *r = &f->machine[f->machines++];
    const char *slash = strrchr(path, '/');
    snprintf(r->folder, sizeof r->folder, "%.*s", slash ? (int)(slash - path) : 0, path);
    return r;
}

/* The table that a file belongs to, by its name or the first words of its header. */
static struct bench_csv **table_of(struct bench_results *r, const char *path, const char *head) {
    if (!strncmp(head, "code,part,", 10)) return &r->cans;
    if (!strncmp(head, "code,", 5)) return &r->lammps;
    return strstr(path, "-traffic.csv") ? &r->traffic : &r->rows;
}

static void read_table(struct bench_files *f, const char *path) {
    char head[64] = "";
    FILE *file = read_file_is_special(path) ? NULL : fopen(path, "r");
    if (!file) die(EXIT_CODE_FILE, "%s: cannot be opened", path);
    if (!fgets(head, sizeof head, file)) head[0] = '\0';
    fclose(file);
    struct bench_results *r = machine_of(f, path, 1);
    struct bench_csv **to = table_of(r ? r : add_machine(f, path), path, head);
    *to = bench_csv_read(*to, path);
}

static void read_run(struct bench_files *f, const char *path) {
    struct bench_results *r = machine_of(f, path, 0);
    if (!r) die(EXIT_CODE_FILE, "%s: is in none of the folders of the tables", path);
    if (r->runs < BENCH_RUNS_MAX) r->run[r->runs++] = bench_whole_read(path);
}

void bench_files_read(struct bench_files *f, int n, const char *const *path) {
    for (int k = 0; k < n; k++)
        if (!is_run(path[k])) read_table(f, path[k]);
    for (int k = 0; k < n; k++)
        if (is_run(path[k])) read_run(f, path[k]);
}

void bench_files_free(struct bench_files *f) {
    for (int m = 0; m < f->machines; m++) {
        struct bench_results *r = &f->machine[m];
        struct bench_csv *const table[] = {r->rows, r->traffic, r->lammps, r->cans};
        for (int k = 0; k < (int)(sizeof table / sizeof *table); k++) bench_csv_free(table[k]);
        for (int k = 0; k < r->runs; k++) bench_whole_free(&r->run[k]);
    }
}

const struct bench_whole *bench_files_run(const struct bench_results *r, enum bench_whole_kind kind) {
    const struct bench_whole *found = NULL;
    for (int k = 0; k < r->runs; k++)
        if (r->run[k].kind == kind) found = &r->run[k];
    return found;
}
