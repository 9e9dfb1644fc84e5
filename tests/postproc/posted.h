/* Run folders that a test has made up and frana post evaluates, and what stands in their post/. */
#pragma once
#include "base/die.h"
#include "base/par.h"
#include "postproc/post.h"
#include "tests/check.h"
#include "tests/postproc/made.h"
#include "tests/postproc/make_run.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <sys/stat.h>
#include <unistd.h>

static const char base[] = FRANA_BINARY_DIR "/tests/postproc/runs";
static char folder[FOLDER_PATH];

static inline char *named(const char *name) { return folder_path(folder, base, name); }

/* The file's bytes, -1 when it is not there. */
static inline long size_of(const char *run, const char *file) {
    char path[FOLDER_PATH];
    struct stat is;
    return stat(folder_path(path, run, file), &is) == 0 ? (long)is.st_size : -1;
}

/* Whether a text file holds the words. */
static inline int holds(const char *run, const char *file, const char *words) {
    char path[FOLDER_PATH], *line = NULL;
    size_t bytes = 0;
    FILE *f = fopen(folder_path(path, run, file), "r");
    int found = 0;
    while (f && getline(&line, &bytes, f) > 0) found |= strstr(line, words) != NULL;
    if (f) fclose(f);
    free(line);
    return found;
}

/* frana post where there is no gnuplot, and with small pictures, both of which take most of the time: pictures, tables
 * and scripts, but neither plots nor slices. */
static inline int post_without_gnuplot(const struct postproc_options *options) {
    char path[4096];
    struct postproc_options small = options ? *options : (struct postproc_options){0};
    small.width = 280;
    snprintf(path, sizeof path, "%s", getenv("PATH"));
    setenv("PATH", "/nowhere", 1);
    const int code = postproc_post(folder, &small);
    setenv("PATH", path, 1);
    return code;
}

/* The value of a quantity in post/summary.csv. */
static inline double summary(const char *run, const char *quantity) {
    return made_value(run, "post/summary.csv", quantity);
}

/* The integral of a density in post/, of the field before or after. */
static inline double integral(const char *run, const char *file, const char *field) {
    char path[FOLDER_PATH], line[256], word[16];
    double t, low, high, density, sum = 0;
    FILE *f = fopen(folder_path(path, run, file), "r");
    while (f && fgets(line, sizeof line, f))
        if (sscanf(line, "%15[^,],%lf,%lf,%lf,%lf", word, &t, &low, &high, &density) == 5 && !strcmp(word, field))
            sum += density * (high - low);
    if (f) fclose(f);
    return sum;
}
