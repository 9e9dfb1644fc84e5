/* Ends the program with one sentence and an exit code: on all ranks together, or from one rank. */
#include "base/die.h"
#include "base/par.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

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
