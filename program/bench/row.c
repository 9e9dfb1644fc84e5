/* Writes rows of measured times and traffic to the screen and to CSV files. */
#include "program/bench/row.h"
#include "base/die.h"
#include "base/par.h"
#include "base/par_count.h"
#include "base/threads.h"
#include "base/files/folder.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

static FILE *open_file(const struct bench_machine *m, const char *folder, const char *ending) {
    char path[FOLDER_PATH], threads[16] = "";
    if (threads_count() > 1) snprintf(threads, sizeof threads, "x%d", threads_count());
    snprintf(path, sizeof path, "%s/%s-%d%s%s.csv", folder, m->slug, par_size(), threads, ending);
    FILE *file = fopen(path, "w");
    if (!file) die(EXIT_CODE_FILE, "%s: cannot be written (%s)", path, strerror(errno));
    return file;
}

void bench_row_begin(struct bench_table *t, const char *folder) {
    t->machine = bench_machine_of();
    if (par_rank() != 0) return;
    printf("%-26s %-12s %10s %10s %10s %9s %-14s %7s %7s %6s\n", "part", "size", "median ms", "low", "high", "ns/unit",
           "unit", "GB/s", "limit", "reached");
    if (!folder) return;
    if (mkdir(folder, 0777) && errno != EEXIST) die(EXIT_CODE_FILE, "%s: cannot be made (%s)", folder, strerror(errno));
    t->file = open_file(&t->machine, folder, "");
    t->traffic = open_file(&t->machine, folder, "-traffic");
    fprintf(t->file, "part,size,ranks,calls,repeats,median_ms,low_ms,high_ms,ns_per_unit,unit,units,bytes_per_unit,"
                     "flops_per_unit,gb_per_s,bandwidth_gb_per_s,peak_gflop_per_s,fraction_of_limit,cpu,cores,"
                     "compiler,flags,fftw,plan,mpi,date,revision\n");
    fprintf(t->traffic, "part,size,ranks,kind,messages,collectives,bytes\n");
}

static void end(FILE *file) {
    if (!file) return;
    const int failed = ferror(file);
    if (fclose(file) || failed) die(EXIT_CODE_FILE, "the bench's table cannot be written");
}

void bench_row_end(struct bench_table *t) {
    end(t->file);
    end(t->traffic);
}

/* Writes a number, or an empty cell if it is not positive. */
static void number(FILE *file, double value) { fprintf(file, value > 0 ? ",%.5g" : ",", value); }

static void row_file(const struct bench_table *t, const struct bench_row *r, double ns, double rate, double fraction) {
    const struct bench_machine *m = &t->machine;
    FILE *file = t->file;
    fprintf(file, "%s,%s,%d", r->part, r->size, par_size());
    number(file, (double)r->time.calls);
    number(file, r->time.repeats);
    number(file, 1e3 * r->time.median);
    number(file, 1e3 * r->time.low);
    number(file, 1e3 * r->time.high);
    number(file, ns);
    fprintf(file, ",%s,%.0f", r->unit, r->units);
    number(file, r->bytes);
    number(file, r->flops);
    number(file, 1e-9 * rate);
    number(file, 1e-9 * t->limits.together);
    number(file, 1e-9 * t->limits.peak);
    number(file, fraction);
    fprintf(file, ",%s,%d,%s,%s,%s,%s,%s,%s,%s\n", m->cpu, m->cores, m->compiler, m->flags, m->fftw, m->plan, m->mpi,
            m->date, m->revision);
    fflush(file);
}

void bench_row_write(struct bench_table *t, const struct bench_row *r) {
    if (par_rank() != 0) return;
    const double seconds = r->time.median;
    const double ns = seconds > 0 ? 1e9 * seconds * par_size() / r->units : 0; /* of one core */
    const double rate = seconds > 0 ? r->bytes * r->units / seconds : 0;
    const double least = bench_limits_seconds(&t->limits, r->bytes * r->units, r->flops * r->units);
    const double fraction = seconds > 0 ? least / seconds : 0;
    if (seconds > 0)
        printf("%-26s %-12s %10.4f %10.4f %10.4f %9.3f %-14s", r->part, r->size, 1e3 * seconds, 1e3 * r->time.low,
               1e3 * r->time.high, ns, r->unit);
    else
        printf("%-26s %-12s %42s %-14s %.2f B", r->part, r->size, "", r->unit, r->bytes);
    if (fraction > 0) printf(" %7.2f %7.2f %5.0f%%", 1e-9 * rate, 1e9 * least / r->units * par_size(), 100 * fraction);
    printf("\n");
    fflush(stdout);
    if (t->file) row_file(t, r, ns, rate, fraction);
}

void bench_row_write_cells(struct bench_table *t, const int n[3], struct bench_row row) {
    snprintf(row.size, sizeof row.size, "%dx%dx%d", n[0], n[1], n[2]);
    bench_row_write(t, &row);
}

void bench_row_memory(struct bench_table *t, const char *part, const char *size, double bytes, double units,
                      const char *unit) {
    struct bench_row row = {.part = part, .units = units, .unit = unit, .bytes = bytes / units};
    snprintf(row.size, sizeof row.size, "%s", size);
    bench_row_write(t, &row);
}

void bench_row_traffic(struct bench_table *t, const char *part, const char *size, bench_call *call, void *with,
                       int calls) {
    double sent[PAR_COUNT_KINDS][3];
    for (int k = 0; k < PAR_COUNT_KINDS; k++) {
        const struct par_count c = par_count_of((enum par_count_kind)k);
        sent[k][0] = -(double)c.messages, sent[k][1] = -(double)c.collectives, sent[k][2] = -(double)c.bytes;
    }
    for (int k = 0; k < calls; k++) call(with);
    for (int k = 0; k < PAR_COUNT_KINDS; k++) {
        const struct par_count c = par_count_of((enum par_count_kind)k);
        sent[k][0] += (double)c.messages, sent[k][1] += (double)c.collectives, sent[k][2] += (double)c.bytes;
    }
    par_max_array(&sent[0][0], 3 * PAR_COUNT_KINDS);
    for (int k = 0; k < PAR_COUNT_KINDS && par_rank() == 0; k++) {
        if (sent[k][0] + sent[k][1] == 0) continue;
        const double messages = sent[k][0] / calls, collectives = sent[k][1] / calls, bytes = sent[k][2] / calls;
        const char *kind = par_count_name((enum par_count_kind)k);
        printf("%-26s %-12s sends a call: %.6g messages, %.6g collectives, %.6g bytes (%s)\n", part, size, messages,
               collectives, bytes, kind);
        if (t->traffic)
            fprintf(t->traffic, "%s,%s,%d,%s,%.6g,%.6g,%.6g\n", part, size, par_size(), kind, messages, collectives,
                    bytes);
    }
}
