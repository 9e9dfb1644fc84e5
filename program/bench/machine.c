/* Describes the machine and the program for a table's rows. */
#include "program/bench/machine.h"
#include "base/libraries.h"
#include "base/machine.h"
#include "base/version.h"
#include "fluid/poisson/transform.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* Copies a text for a CSV's cell, without commas, quotes and line ends. */
static void cell(char *to, size_t size, const char *from) {
    snprintf(to, size, "%.*s", (int)size - 1, from);
    for (char *c = to; *c; c++)
        if (*c == ',' || *c == '"' || *c == '\n') *c = ';';
}

static void slug(char *to, size_t size, const char *from) {
    size_t n = 0;
    for (; *from && n + 1 < size; from++) {
        if (isalnum((unsigned char)*from))
            to[n++] = (char)tolower((unsigned char)*from);
        else if (n > 0 && to[n - 1] != '-')
            to[n++] = '-';
    }
    while (n > 0 && to[n - 1] == '-') n--;
    to[n] = '\0';
}

struct bench_machine bench_machine_of(void) {
    struct bench_machine m = {.cores = machine_cores()};
    char library[3][128], processor[sizeof m.cpu];
    const time_t now = time(NULL);
    libraries_describe(library);
    machine_processor(processor, sizeof processor);
    cell(m.cpu, sizeof m.cpu, processor);
    slug(m.slug, sizeof m.slug, m.cpu);
    cell(m.compiler, sizeof m.compiler, FRANA_COMPILER);
    cell(m.flags, sizeof m.flags, FRANA_FLAGS);
    cell(m.mpi, sizeof m.mpi, library[0]);
    cell(m.fftw, sizeof m.fftw, library[2]);
    cell(m.plan, sizeof m.plan, FLUID_TRANSFORM_PLAN);
    cell(m.revision, sizeof m.revision, FRANA_REVISION);
    strftime(m.date, sizeof m.date, "%Y-%m-%d", gmtime(&now));
    return m;
}
