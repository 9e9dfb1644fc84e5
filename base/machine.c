/* Processor name, number of cores and memory of this machine. */
#include "base/machine.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>
#include <unistd.h>

void machine_processor(char *to, size_t size) {
    struct utsname system;
    uname(&system);
    snprintf(to, size, "%s", system.machine);
    FILE *file = fopen("/proc/cpuinfo", "r");
    char line[256];
    while (file && fgets(line, sizeof line, file)) {
        char *colon = strchr(line, ':');
        if (strncmp(line, "model name", 10) || !colon) continue;
        line[strcspn(line, "\n")] = '\0';
        snprintf(to, size, "%s", colon + 1 + strspn(colon + 1, " "));
        break;
    }
    if (file) fclose(file);
}

int machine_cores(void) { return (int)sysconf(_SC_NPROCESSORS_ONLN); }

/* The number in a file; SIZE_MAX where there is no file, or no number in it ("max"). */
static size_t number_in(const char *path) {
    char text[64] = "", *end = text;
    FILE *file = fopen(path, "r");
    if (!file) return SIZE_MAX;
    const unsigned long long value = fgets(text, sizeof text, file) ? strtoull(text, &end, 10) : 0;
    fclose(file);
    return end == text || value >= SIZE_MAX ? SIZE_MAX : (size_t)value;
}

static int names_memory(const char *controllers) {
    const char *at = strstr(controllers, "memory");
    return at && (at == controllers || at[-1] == ',') && (at[6] == ',' || at[6] == '\0');
}

/* Of a group and those above it: below/PATH/name, with fewer and fewer words of PATH. */
static size_t least_above(const char *below, char *path, const char *name) {
    size_t least = SIZE_MAX;
    for (;;) {
        char full[1024];
        if (snprintf(full, sizeof full, "%s%s/%s", below, path, name) < (int)sizeof full) {
            const size_t here = number_in(full);
            if (here < least) least = here;
        }
        char *slash = strrchr(path, '/');
        if (!slash) return least;
        *slash = '\0';
    }
}

size_t machine_memory_limit(const char *groups, const char *mounted) {
    size_t least = SIZE_MAX;
    char line[1024], below[512];
    FILE *file = fopen(groups, "r");
    while (file && fgets(line, sizeof line, file)) { /* hierarchy:controllers:/path */
        char *at = line;
        line[strcspn(line, "\n")] = '\0';
        if (!strsep(&at, ":") || !at) continue;
        const char *controllers = strsep(&at, ":");
        if (!at || (*controllers && !names_memory(controllers))) continue;
        snprintf(below, sizeof below, "%s%s", mounted, *controllers ? "/memory" : "");
        const size_t here = least_above(below, at, *controllers ? "memory.limit_in_bytes" : "memory.max");
        if (here < least) least = here;
    }
    if (file) fclose(file);
    return least;
}

size_t machine_memory(void) {
    const size_t has = (size_t)sysconf(_SC_PHYS_PAGES) * (size_t)sysconf(_SC_PAGESIZE);
    const size_t may = machine_memory_limit("/proc/self/cgroup", "/sys/fs/cgroup");
    return may < has ? may : has;
}
