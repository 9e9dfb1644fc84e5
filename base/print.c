/* Prints on rank 0. */
#include "base/print.h"
#include "base/par.h"

#include <stdarg.h>
#include <stdio.h>

void print(const char *format, ...) {
    if (par_rank() != 0) return;
    va_list args;
    va_start(args, format);
    vprintf(format, args);
    va_end(args);
}
