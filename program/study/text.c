/* Reads numbers and cells, and turns names into folder names. */
#include "program/study/text.h"
#include "base/arena.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

double study_text_number(const char *text) {
    char *end;
    if (!text) return NAN;
    const double value = strtod(text, &end);
    if (end == text) return NAN;
    while (isspace((unsigned char)*end)) end++;
    return *end ? NAN : value;
}

char *study_text_slug(const char *text) {
    char *slug = arena_text("%s", *text ? text : "-");
    for (char *c = slug; *c; c++)
        if (!isalnum((unsigned char)*c) && *c != '.' && *c != '_') *c = '-';
    if (slug[0] == '.') slug[0] = '-';
    return slug;
}

char *study_text_cell(char **line) {
    char *at = *line, *to = at, *start = at;
    if (!at) return NULL;
    int quoted = 0;
    for (; *at && (quoted || *at != ','); at++)
        if (*at == '"')
            quoted = !quoted;
        else
            *to++ = *at;
    *line = *at ? at + 1 : NULL;
    *to = '\0';
    return start;
}
