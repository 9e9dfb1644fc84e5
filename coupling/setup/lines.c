/* Reads text files of numbers, line by line. */
#include "coupling/setup/lines.h"
#include "base/die.h"
#include "base/par.h"
#include "base/text.h"
#include "base/files/plain_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int numbers_of(const char *line, double value[SETUP_LINES_MAX]) {
    int n = 0;
    for (char *end;; line = end) {
        line += strspn(line, " \t\r\n,");
        if (!*line || *line == '#') return n;
        const double v = strtod(line, &end);
        if (end == line) return -1;
        if (n == SETUP_LINES_MAX) return SETUP_LINES_MAX + 1;
        value[n++] = v;
    }
}

/* "0,5 1 1": a comma between two digits, and blanks besides, so that nobody knows which of them separate. Where a
 * number has a decimal point, the commas separate. */
static int has_decimal_commas(const char *line) {
    static const char digits[] = "0123456789";
    const char *end = line + strcspn(line, "#\r\n");
    int comma = 0, blank = 0, before = 0; /* before: a number has begun */
    for (const char *at = line; at < end; at++) {
        const int is_blank = *at == ' ' || *at == '\t';
        comma |= *at == ',' && at > line && strchr(digits, at[-1]) && at + 1 < end && strchr(digits, at[1]);
        blank |= is_blank && before && at + 1 + strspn(at + 1, " \t") < end;
        before |= !is_blank;
    }
    return comma && blank && !memchr(line, '.', (size_t)(end - line));
}

long setup_lines_read(const char *path, const char *what, setup_lines_taker *take, void *with, char **why) {
    FILE *file = plain_file_read(path);
    double value[SETUP_LINES_MAX];
    char *line = NULL;
    size_t size = 0;
    ssize_t bytes;
    long taken = 0;
    *why = file ? NULL : text_new("the %s can't be opened", what);
    for (long at = 1; !*why && (bytes = getline(&line, &size, file)) > 0; at++) {
        if (has_decimal_commas(line)) {
            *why = text_new("line %ld: has a comma between two digits, and blanks between others; numbers need a "
                            "decimal point, as 0.5",
                            at);
            break;
        }
        const int n = strlen(line) == (size_t)bytes ? numbers_of(line, value) : -1; /* a zero byte does not end a
                                                                                     * line */
        if (n == 0) continue;
        *why = take(with, at, n, value);
        taken += !*why;
    }
    free(line);
    if (file) fclose(file);
    return taken;
}

void setup_lines_die(const char *path, char *why) {
    char text[256] = "";
    if (why) snprintf(text, sizeof text, "%s", why);
    free(why);
    par_bcast(text, sizeof text, 0);
    if (text[0]) die_all(EXIT_CODE_SCENE, "%s: %s", path, text);
}
