/* Ends the program with one sentence and an exit code: on all ranks together, or from one rank. */
#include "base/die.h"
#include "base/par.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

/* Prints the sentence, cut where it is longer than any that a user would read. */
static void say(const char *format, va_list args) {
    enum { MOST = 4000 };
    char text[MOST];
    const int n = vsnprintf(text, sizeof text, format, args);
    fprintf(stderr, "%s%s\n", text, n >= MOST ? "..." : "");
}

void die_all(enum exit_code code, const char *format, ...) {
    if (par_rank() == 0) {
        va_list args;
        va_start(args, format);
        fputs("frana: ", stderr);
        say(format, args);
        va_end(args);
    }
    par_end();
    exit(code);
}

void die(enum exit_code code, const char *format, ...) {
    va_list args;
    va_start(args, format);
    fprintf(stderr, "frana: rank %d: ", par_rank());
    say(format, args);
    va_end(args);
    par_abort(code);
}
