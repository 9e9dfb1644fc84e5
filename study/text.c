/* Reads files and numbers as text, and turns names into folder names. */
#include "study/text.h"
#include "base/text.h"
#include "scene/text/yaml.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *study_text_of(const char *path) {
    FILE *in = fopen(path, "rb");
    if (!in) return NULL;
    size_t bytes = 0, room = 1 << 14;
    char *text = malloc(room);
    for (size_t n; (n = fread(text + bytes, 1, room - bytes - 1, in)) > 0;) {
        bytes += n;
        if (bytes + 1 == room) text = realloc(text, room *= 2);
    }
    const int bad = ferror(in);
    fclose(in);
    text[bytes] = '\0';
    if (!bad) return text;
    free(text);
    return NULL;
}

struct scene_node *study_text_tree(const char *path) {
    struct scene_problems problems = {.file = path};
    char *text = study_text_of(path);
    struct scene_node *root = text ? scene_yaml_parse(text, strlen(text), &problems) : NULL;
    scene_problem_free(&problems);
    free(text);
    return root;
}

double study_text_number(const char *text) {
    char *end;
    if (!text) return NAN;
    const double value = strtod(text, &end);
    if (end == text) return NAN;
    while (isspace((unsigned char)*end)) end++;
    return *end ? NAN : value;
}

char *study_text_slug(const char *text) {
    char *slug = text_new("%s", *text ? text : "-");
    for (char *c = slug; *c; c++)
        if (!isalnum((unsigned char)*c) && *c != '.' && *c != '_') *c = '-';
    if (slug[0] == '.') slug[0] = '-';
    return slug;
}
