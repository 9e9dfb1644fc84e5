/* Finds a key by its path, and puts its range, unit and words into text. */
#include "scene/keys/key.h"
#include "base/ensure.h"
#include "base/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const struct scene_key *scene_key_beside(const struct scene_key *keys, const char *name) {
    for (const struct scene_key *key = keys; key->name; key++)
        if (!strcmp(key->name, name)) return key;
    return NULL;
}

char *scene_key_path(const char *path, const struct scene_key *key) {
    return text_new("%s%s%s", path, *path ? "." : "", key->described ? key->described : key->name);
}

/* Puts a path with one more part in place of *path, if path is not NULL. */
static void extend(char **path, const struct scene_key *key) {
    if (!path) return;
    char *longer = key ? scene_key_path(*path, key) : text_new("%s[]", *path);
    free(*path);
    *path = longer;
}

/* The end of the brackets [...] at the beginning of a path; NULL: there are none. */
static const char *after_brackets(const char *path) {
    return *path == '[' && strchr(path, ']') ? strchr(path, ']') + 1 : NULL;
}

static const struct scene_key *find(const char *path, char **described) {
    const struct scene_value *v = &scene_table_scene;
    for (;;) {
        const size_t n = strcspn(path, ".[");
        const struct scene_key *key = v->keys;
        while (key->name && !(strlen(key->name) == n && !strncmp(key->name, path, n))) key++;
        if (!key->name) return NULL;
        extend(described, key);
        path += n;
        v = &key->value;
        if (!*path) return key;
        if (v->type == SCENE_LIST) {
            path = after_brackets(path);
            v = v->entry;
            extend(described, NULL);
        }
        if (!path || *path != '.' || v->type != SCENE_SECTION) return NULL;
        path++;
    }
}

const struct scene_key *scene_key_find(const char *path, char **described) {
    if (described) *described = text_new("%s", "");
    const struct scene_key *key = find(path, described);
    if (key || !described) return key;
    free(*described);
    *described = NULL;
    return NULL;
}

int scene_key_is_among(const char *word, const char *list) {
    const size_t n = strlen(word);
    for (const char *at = list; *at; at += strcspn(at, " "), at += *at == ' ')
        if (strcspn(at, " ") == n && !strncmp(at, word, n)) return 1;
    return 0;
}

/* Appends a word to a list of words, which is malloc'ed. */
static char *joined(char *list, const char *word) {
    char *longer = text_new("%s%s%s", list, *list ? " " : "", word);
    free(list);
    return longer;
}

char *scene_key_values(const struct scene_key *keys, const struct scene_key *key) {
    if (*key->values) return text_new("%s", key->values);
    const struct scene_key *sibling = scene_key_beside(keys, key->sibling);
    ENSURE(sibling && sibling->value.type == SCENE_CHOICE, "%s goes by %s", key->name, key->sibling);
    char *list = text_new("%s", "");
    for (int i = 0; i < sibling->value.most; i++)
        if (scene_key_is_among(key->name, sibling->value.words[i].takes))
            list = joined(list, sibling->value.words[i].word);
    return list;
}

char *scene_key_words(const struct scene_key *key, enum scene_need dimension) {
    const struct scene_value *v = &key->value;
    int differ = 0;
    for (int i = 0; v->type == SCENE_CHOICE && i < v->most; i++) differ |= v->words[i].only;
    if (!differ) return NULL;
    char *list = text_new("%s", "");
    for (int i = 0; i < v->most; i++)
        if (!v->words[i].only || v->words[i].only & (int)dimension) list = joined(list, v->words[i].word);
    return list;
}

char *scene_key_joined(int n, const char *const *name) {
    char *text = text_new("%s", "");
    for (int i = 0; i < n; i++) {
        char *longer = text_new("%s%s%s", text, i ? ", " : "", name[i]);
        free(text);
        text = longer;
    }
    return text;
}

int scene_key_is_needed(const struct scene_key *key) {
    return key->needed & SCENE_ALWAYS && !key->only && !key->sibling && !key->with && !key->not_with;
}

char *scene_key_range(const struct scene_key *key) {
    if (key->low == key->high) return NULL;
    const char *below = key->open & 2 ? "less than" : "at most", *above = key->open & 1 ? "greater than" : "at least";
    if (isinf(key->high)) return text_new("%s %.15g", above, key->low);
    if (!key->open) return text_new("between %.15g and %.15g", key->low, key->high);
    return text_new("%s %.15g and %s %.15g", above, key->low, below, key->high);
}

int scene_key_admits(const struct scene_key *key, double value) {
    if (key->low == key->high) return 1;
    if (value < key->low || (key->open & 1 && value == key->low)) return 0;
    return value <= key->high && !(key->open & 2 && value == key->high);
}

char *scene_key_in_units(const struct scene_key *key) {
    static const char *const none[] = {"1", "text", "bool", "choice", "section", "list", "file"};
    for (size_t i = 0; key && i < sizeof none / sizeof *none; i++)
        if (!strcmp(key->unit, none[i])) key = NULL;
    return key ? text_new(" (%s)", key->unit) : text_new("%s", "");
}
