/* Ends the program with one sentence and an exit code: on all ranks together, or from one rank. */
#include "base/die.h"
#include "base/par.h"
#include "base/sanitize.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Prints the sentence, cut where it is longer than any that a user would read, without the long words and control
 * characters that a command line may bring. It is written at once, so that a launcher's own lines cannot stand within
 * it. */
static void report(const char *who, const char *format, va_list args) {
    enum { MOST = 4000 };
    char *text = NULL;
    if (vasprintf(&text, format, args) < 0) text = NULL;
    if (text) sanitize_text(text);
    fprintf(stderr, "frana: %s%.*s%s\n", who, MOST, text ? text : "no memory left",
            text && strlen(text) > MOST ? "..." : "");
    free(text);
}

void die_all(enum exit_code code, const char *format, ...) {
    if (par_rank() == 0) {
        va_list args;
        va_start(args, format);
        report("", format, args);
        va_end(args);
    }
    par_end();
    exit(code);
}

void die(enum exit_code code, const char *format, ...) {
    va_list args;
    va_start(args, format);
    char who[32];
    snprintf(who, sizeof who, "rank %d: ", par_rank());
    report(who, format, args);
    va_end(args);
    par_abort(code);
}
