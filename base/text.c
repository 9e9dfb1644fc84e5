/* Texts of any length, by printf. */
#include "base/text.h"
#include "base/die.h"

#include <stdarg.h>
#include <stdio.h>

char *text_new(const char *format, ...) {
    va_list args;
    va_start(args, format);
    char *text = NULL;
    if (vasprintf(&text, format, args) < 0) die(EXIT_CODE_FILE, "no memory left for a text");
    va_end(args);
    return text;
}
