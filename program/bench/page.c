/* Reads the files that a page is made of. */
#include "program/bench/page.h"
#include "base/die.h"
#include "base/files/whole.h"

#include <stdio.h>
#include <string.h>

/* The table that a file belongs to, told by its name or by the first words of its header. */
static struct bench_cells **table_of(struct bench_page_files *p, const char *path, const char *head) {
    const struct {
        const char *begins;
        struct bench_cells **to;
    } kind[] = {{"code,part,", &p->flow},
                {"code,", &p->peer},
                {"peer,", &p->earlier},
                {"part,size,ranks,bytes_per_unit,", &p->bytes}};
    for (int k = 0; k < (int)(sizeof kind / sizeof *kind); k++)
        if (!strncmp(head, kind[k].begins, strlen(kind[k].begins))) return kind[k].to;
    return strstr(path, "-traffic.csv") ? &p->traffic : &p->rows;
}

void bench_page_read(struct bench_page_files *p, const char *path) {
    const size_t length = strlen(path);
    char head[64] = "";
    if (length > 5 && !strcmp(path + length - 5, ".json")) {
        if (p->runs < BENCH_RUNS_MAX) p->run[p->runs++] = bench_whole_read(path);
        return;
    }
    FILE *file = whole_is_no_file(path) ? NULL : fopen(path, "r");
    if (!file) die(EXIT_CODE_FILE, "%s: cannot be opened", path);
    if (!fgets(head, sizeof head, file)) head[0] = '\0';
    fclose(file);
    struct bench_cells **to = table_of(p, path, head);
    *to = bench_cells_read(*to, path);
}

void bench_page_free(struct bench_page_files *p) {
    struct bench_cells *const table[] = {p->rows, p->traffic, p->peer, p->flow, p->earlier, p->bytes};
    for (int k = 0; k < (int)(sizeof table / sizeof *table); k++) bench_cells_free(table[k]);
    for (int k = 0; k < p->runs; k++) bench_whole_free(&p->run[k]);
}

const struct bench_whole *bench_page_run(const struct bench_page_files *p, enum bench_whole_kind kind) {
    const struct bench_whole *found = NULL;
    for (int k = 0; k < p->runs; k++)
        if (p->run[k].kind == kind) found = &p->run[k];
    return found;
}
