#include "bench/machine.h"
#include "base/libraries.h"
#include "base/version.h"
#include "fluid/transform.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

/* Text for a CSV's cell: no commas, quotes or line ends. */
static void cell(char *to, size_t size, const char *from) {
    snprintf(to, size, "%.*s", (int)size - 1, from);
    for (char *c = to; *c; c++)
        if (*c == ',' || *c == '"' || *c == '\n') *c = ';';
}

/* "model name" of /proc/cpuinfo, or the architecture where there is none. */
static void processor(char *to, size_t size) {
    struct utsname system;
    uname(&system);
    cell(to, size, system.machine);
    FILE *file = fopen("/proc/cpuinfo", "r");
    char line[256];
    while (file && fgets(line, sizeof line, file)) {
        char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) || !colon) continue;
        line[strcspn(line, "\n")] = '\0';
        cell(to, size, colon + 1 + strspn(colon + 1, " "));
        break;
    }
    if (file) fclose(file);
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
    struct bench_machine m = {.cores = (int)sysconf(_SC_NPROCESSORS_ONLN)};
    char library[3][128];
    const time_t now = time(NULL);
    libraries_describe(library);
    processor(m.cpu, sizeof m.cpu);
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
