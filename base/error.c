#include "base/error.h"
#include "base/par.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void ensure_failed(const char *file, int line, const char *cond, const char *format, ...) {
    va_list args;
    va_start(args, format);
    fprintf(stderr, "frana: bug on rank %d at %s:%d: %s: ", par_rank(), file, line, cond);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
    par_abort(134);
}

void die_all(enum exit_code code, const char *format, ...) {
    if (par_rank() == 0) {
        va_list args;
        va_start(args, format);
        fputs("frana: ", stderr);
        vfprintf(stderr, format, args);
        fputc('\n', stderr);
        va_end(args);
    }
    par_end();
    exit(code);
}

void die(enum exit_code code, const char *format, ...) {
    va_list args;
    va_start(args, format);
    fprintf(stderr, "frana: rank %d: ", par_rank());
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
    par_abort(code);
}

int step_status_agree(struct step_status *status) {
    const int size = par_size();
    int first = (int)par_min(status->failed ? par_rank() : size);
    if (first == size) return 0;
    par_bcast(status, sizeof *status, first);
    return 1;
}
