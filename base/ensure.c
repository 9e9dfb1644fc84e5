/* Prints which internal condition failed and where, and aborts all ranks. */
#include "base/ensure.h"
#include "base/par.h"

#include <stdarg.h>
#include <stdio.h>

void ensure_failed(const char *file, int line, const char *cond, const char *format, ...) {
    va_list args;
    va_start(args, format);
    fprintf(stderr, "frana: bug on rank %d at %s:%d: %s: ", par_rank(), file, line, cond);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
    par_abort(134);
}
