/* Stores in the user's cache how long cells, particles and bonds took in runs on this machine, and reads it. */
#include "program/check/speed.h"
#include "base/clock.h"
#include "base/machine.h"
#include "base/par.h"
#include "base/par_shared.h"
#include "base/sort.h"
#include "base/vec_type.h"
#include "base/version.h"
#include "base/files/cache.h"
#include "base/files/read_file.h"
#include "program/output/amount.h"
#include "solid/step/integrate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { LINE = 640, LINES = 200, NEWEST = 9 };
#define NAME "speed.csv"
#define HEAD                                                                                                           \
    "#processor,cores,build,kind,ranks,seconds since 1970,ns a cell and step,ns a particle of the interface and "      \
    "step,ns a directed bond and sweep,ns a cell or directed bond and sample,ns a byte of fields and checkpoints,"     \
    "the rest over these,cells,particles of the interface,directed bonds\n"

/* A text as a field of the file. */
static void field(char to[SPEED_TEXT], const char *text) {
    snprintf(to, SPEED_TEXT, "%s", text);
    for (char *c = to; *c; c++)
        if (*c == ',' || (unsigned char)*c < ' ') *c = ' ';
}

/* Compiler, flags and vectors in one number: another build has another speed. */
static void build_of(char to[SPEED_TEXT]) {
    unsigned long long hash = 14695981039346656037ull; /* FNV-1a */
    for (const char *c = FRANA_COMPILER " " FRANA_FLAGS " " VEC_NAME; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 1099511628211ull;
    snprintf(to, SPEED_TEXT, "%s %016llx", FRANA_VERSION, hash);
}

static void kind_of(const struct run *r, char to[SPEED_TEXT]) {
    const struct scene *s = r->scene;
    const int reacts = r->reaction != NULL;
    snprintf(to, SPEED_TEXT, "%s%s%s%s%s%s%s%s%s", s->dimension == 2 ? "plate" : "space", r->fluid ? " fluid" : "",
             r->fluid && s->fluid->diffusion == SCENE_DIFFUSION_IMPLICIT ? " implicit" : "",
             r->fluid && s->fluid->projection == FLUID_LAST_STAGE ? " last_stage" : "",
             r->fluid && fluid_input_of(r->fluid)->keeps_rate ? " ab2" : "", r->needs.immersed ? " immersed" : "",
             r->needs.bonds ? " bonds" : "", reacts ? " reaction" : "", r->cracks ? " crack_fluid" : "");
}

struct speed_sample speed_sample_for(const struct run *r) {
    struct speed_sample s = {.cores = machine_cores(), .ranks = par_size(), .when = (double)time(NULL)};
    char processor[SPEED_TEXT];
    machine_processor(processor, sizeof processor);
    field(s.processor, processor);
    build_of(s.build);
    kind_of(r, s.kind);
    s.size[SPEED_CELLS] = r->fluid ? (double)fluid_cells(r->fluid) : 0;
    s.size[SPEED_PARTICLES] = r->surface ? (double)r->surface->total : 0;
    s.size[SPEED_BONDS] = (double)run_directed_bonds(r);
    return s;
}

static const struct {
    enum clock_part clock;
    enum speed_part part;
} timed[] = {{CLOCK_MOMENTUM, SPEED_CELL},    {CLOCK_POISSON, SPEED_CELL},   {CLOCK_HALO, SPEED_CELL},
             {CLOCK_FORCING, SPEED_IMMERSED}, {CLOCK_PROBE, SPEED_IMMERSED}, {CLOCK_INTERFACE, SPEED_IMMERSED},
             {CLOCK_SOLID, SPEED_BOND},       {CLOCK_CONTACT, SPEED_BOND},   {CLOCK_SERIES, SPEED_SAMPLE},
             {CLOCK_FIELDS, SPEED_FILE},      {CLOCK_CHECKPOINT, SPEED_FILE}};
enum { TIMED = sizeof timed / sizeof *timed };

void speed_amounts(const struct run *r, double steps, double cells, double sweeps, double amount[SPEED_PARTS]) {
    memset(amount, 0, SPEED_PARTS * sizeof *amount);
    amount[SPEED_CELL] = cells;
    amount[SPEED_IMMERSED] = r->surface ? (double)r->surface->total * steps : 0;
    amount[SPEED_BOND] = sweeps * (double)run_directed_bonds(r);
}

void speed_outputs(struct run *r, long from, long to, double amount[SPEED_PARTS]) {
    const double samples = (double)amount_samples(r, r->scene->output.series_every, from, to);
    amount[SPEED_SAMPLE] = samples * ((r->fluid ? (double)fluid_cells(r->fluid) : 0) + (double)run_directed_bonds(r));
    amount[SPEED_FILE] = amount_bytes(r, from, to);
}

struct speed_work speed_work_done(struct run *r) {
    struct speed_work w = {
        .seconds = par_max(par_seconds() - r->wall_start - r->setup_seconds - clock_seconds(CLOCK_PERMEABILITY))};
    for (int k = 0; k < TIMED; k++) w.seconds_of[timed[k].part] += clock_seconds(timed[k].clock);
    par_sum_array(w.seconds_of, SPEED_PARTS);
    speed_amounts(r, (double)(r->step - r->resumed), (double)r->fluid_cell_steps, (double)r->solid_sweeps, w.amount);
    speed_outputs(r, r->resumed, r->step, w.amount);
    return w;
}

void speed_store_step(const struct run *r, double seconds, const double *clock) {
    struct speed_work w = {.seconds = seconds};
    for (int k = 0; k < TIMED; k++) w.seconds_of[timed[k].part] += clock[timed[k].clock] * par_size();
    speed_amounts(r, 1, r->fluid ? (double)fluid_cells(r->fluid) : 0,
                  r->needs.bonds ? (double)solid_integrate_sweeps(r->solid, r->substeps) : 0, w.amount);
    speed_store_work(r, &w, 0);
}

int speed_sample_set(const struct speed_work *work, struct speed_sample *sample) {
    double sum = 0;
    for (int p = 0; p < SPEED_REST; p++) {
        sample->part[p] = work->amount[p] > 0 ? 1e9 * work->seconds_of[p] / work->amount[p] : 0;
        if (sample->part[p] > 0) sum += work->seconds_of[p] / sample->ranks;
    }
    sample->part[SPEED_REST] = sum > 0 ? fmax(work->seconds / sum - 1, 0) : 0;
    return sum > 0 && isfinite(sum);
}

void speed_store_work(const struct run *r, const struct speed_work *work, double least) {
    const int crowded = par_max(par_shared_ranks() > machine_cores()) > 0;
    struct speed_sample s = speed_sample_for(r);
    int relaxes = 0; /* the number of its steps is not counted */
    for (int k = 0; k < r->scene->stages; k++) relaxes |= r->scene->stage[k].relax;
    if (par_rank() != 0 || crowded || relaxes || !(work->seconds >= least)) return;
    if (speed_sample_set(work, &s)) speed_append(&s);
}

/* Opens the file if it is one, and not a pipe, which one would wait for. */
static FILE *open_file(void) {
    char path[CACHE_PATH];
    return cache_path(path, NAME, 0) && !read_file_is_special(path) ? fopen(path, "r") : NULL;
}

/* The sample of a line; 0: the line is none. */
static int read_line(const char *line, struct speed_sample *s) {
    enum { FIRST = 6, SIZE = FIRST + SPEED_PARTS, WORDS = SIZE + SPEED_SIZES };
    char text[LINE], *at = text, *word[WORDS], *end;
    int n = 0;
    snprintf(text, sizeof text, "%s", line);
    if (!strchr(text, '\n') || *text == '#') return 0;
    while (n < WORDS && (word[n] = strsep(&at, ",\n"))) n++;
    if (n < WORDS) return 0;
    *s = (struct speed_sample){0};
    field(s->processor, word[0]);
    field(s->build, word[2]);
    field(s->kind, word[3]);
    s->cores = (int)strtol(word[1], NULL, 10);
    s->ranks = (int)strtol(word[4], NULL, 10);
    s->when = strtod(word[5], NULL);
    int good = s->cores > 0 && s->ranks > 0 && isfinite(s->when);
    for (int p = 0; p < SPEED_PARTS + SPEED_SIZES; p++) {
        double *value = p < SPEED_PARTS ? &s->part[p] : &s->size[p - SPEED_PARTS];
        *value = strtod(word[FIRST + p], &end);
        good = good && end != word[FIRST + p] && !*end && *value >= 0 && (p >= SPEED_PARTS || *value < 1e9);
    }
    return good && isfinite(s->size[0] + s->size[1] + s->size[2]);
}

static int is_same_machine(const struct speed_sample *a, const struct speed_sample *b) {
    return a->cores == b->cores && !strcmp(a->processor, b->processor) && !strcmp(a->build, b->build);
}

/* The largest ratio of two sizes, >= 1. */
static double apart(const struct speed_sample *a, const struct speed_sample *b) {
    double most = 1;
    for (int k = 0; k < SPEED_SIZES; k++) {
        const double one = fmax(a->size[k], 1), other = fmax(b->size[k], 1);
        most = fmax(most, fmax(one / other, other / one));
    }
    return most;
}

/* The medians of the newest samples at most so far apart; the file has the newest last. */
static void find(const struct speed_sample *all, int n, const struct speed_sample *like, double most,
                 struct speed_estimate *known) {
    double value[SPEED_PARTS][NEWEST];
    int found[SPEED_PARTS] = {0};
    for (int k = n - 1; k >= 0 && known->samples < NEWEST; k--) {
        if (known->same_kind && strcmp(all[k].kind, like->kind) != 0) continue;
        if (known->same_ranks && all[k].ranks != like->ranks) continue;
        if (apart(&all[k], like) > most) continue;
        known->samples++;
        known->apart = fmax(known->apart, apart(&all[k], like));
        known->newest = fmax(known->newest, all[k].when);
        for (int p = 0; p < SPEED_PARTS; p++)
            if (all[k].part[p] > 0) value[p][found[p]++] = all[k].part[p];
    }
    for (int p = 0; p < SPEED_PARTS; p++) known->part[p] = sort_median(value[p], (size_t)found[p]);
}

struct speed_estimate speed_lookup(const struct speed_sample *like) {
    static const struct {
        int same_kind, same_ranks;
        double apart;
    } preference[] = {
        {1, 1, SPEED_NEAR}, {1, 0, SPEED_NEAR}, {1, 1, 16},       {1, 0, 16},
        {1, 1, INFINITY},   {1, 0, INFINITY},   {0, 0, INFINITY},
    };
    struct speed_estimate known = {0};
    struct speed_sample *all = calloc(LINES, sizeof *all);
    char line[LINE];
    int n = 0;
    FILE *file = all ? open_file() : NULL;
    while (file && n < LINES && fgets(line, sizeof line, file))
        if (read_line(line, &all[n]) && is_same_machine(&all[n], like)) n++;
    if (file) fclose(file);
    for (size_t k = 0; k < sizeof preference / sizeof *preference; k++) {
        struct speed_estimate found = {.same_kind = preference[k].same_kind, .same_ranks = preference[k].same_ranks};
        find(all, n, like, preference[k].apart, &found);
        if (known.samples == 0) known = found;
        for (int p = SPEED_SAMPLE; p <= SPEED_FILE; p++)
            if (!(known.part[p] > 0)) known.part[p] = found.part[p];
    }
    free(all);
    return known;
}

void speed_append(const struct speed_sample *s) {
    struct cache_file file;
    char(*line)[LINE] = calloc(LINES, sizeof *line);
    int n = 0;
    char next[LINE];
    FILE *old = line ? open_file() : NULL;
    struct speed_sample good;
    while (old && fgets(next, sizeof next, old))
        if (read_line(next, &good)) memcpy(line[n++ % (LINES - 1)], next, sizeof next);
    if (old) fclose(old);
    if (line && cache_begin(&file, NAME)) {
        fputs(HEAD, file.file);
        for (int k = n > LINES - 1 ? n - (LINES - 1) : 0; k < n; k++) fputs(line[k % (LINES - 1)], file.file);
        fprintf(file.file, "%s,%d,%s,%s,%d,%.0f", s->processor, s->cores, s->build, s->kind, s->ranks, s->when);
        for (int p = 0; p < SPEED_PARTS; p++) fprintf(file.file, ",%.6g", s->part[p]);
        for (int k = 0; k < SPEED_SIZES; k++) fprintf(file.file, ",%.0f", s->size[k]);
        fputc('\n', file.file);
        cache_end(&file);
    }
    free(line);
}
