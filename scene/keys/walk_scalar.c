/* Checks of single scene values: numbers, choices, texts. */
#include "scene/keys/walk.h"
#include "base/ensure.h"
#include "base/sanitize.h"
#include "base/text.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Numbers between these, and 0, have all digits of a double, and so have their inverses. */
static const double LARGEST = 1e300, SMALLEST = 1e-300;
/* Of speeds, m/s: their squares are such numbers too. */
static const double FASTEST = 1e150;

/* Whether all digits of a number, but for those of its power, are 0. */
static int is_zero(const char *s) {
    const char *end = s + strspn(s, "+-0.");
    return !*end || *end == 'e' || *end == 'E';
}

static int is_whole(const char *s) {
    if (*s == '+' || *s == '-') s++;
    const size_t n = strspn(s, "0123456789");
    return n > 0 && !s[n] && (n == 1 || s[0] != '0');
}

static int is_number(const char *s) {
    if (*s == '+' || *s == '-') s++;
    const size_t before = strspn(s, "0123456789");
    s += before;
    size_t after = 0;
    if (*s == '.') {
        after = strspn(++s, "0123456789");
        s += after;
    }
    if (before + after == 0) return 0;
    if (*s != 'e' && *s != 'E') return !*s;
    if (*++s == '+' || *s == '-') s++;
    const size_t power = strspn(s, "0123456789");
    return power > 0 && !s[power];
}

static int is_speed(const struct scene_key *key) {
    return key && (!strcmp(key->unit, "m/s") || !strcmp(key->unit, "Pa/m or m/s"));
}

/* ", or auto" if the key allows a word instead of a number. */
static char *or_word(const struct scene_key *key) {
    return key && key->word ? text_new(", or %s", key->word) : text_new("%s", "");
}

int scene_walk_scalar_number(struct scene_walk *w, struct scene_node *node, const struct scene_value *v,
                             const struct scene_key *key, const char *path) {
    if (key && key->word && node->kind == SCENE_NODE_SCALAR && !strcmp(node->value, key->word)) return 1;
    struct scene_key in_plate;
    if (key && key->plate_high > 0 && w->dimension != 3) {
        in_plate = *key;
        in_plate.high = key->plate_high;
        in_plate.open &= ~2;
        key = &in_plate;
    }
    const int whole = v->type == SCENE_WHOLE, plain = node->kind == SCENE_NODE_SCALAR && !node->quoted;
    const int form = plain && (whole ? is_whole(node->value) : is_number(node->value));
    const double value = form ? strtod(node->value, NULL) : 0;
    const double largest = is_speed(key)             ? FASTEST
                           : !whole                  ? LARGEST
                           : v->bytes == sizeof(int) ? INT_MAX
                                                     : 9e15; /* integers that a double
                                                              * holds exactly */
    const int admitted = !key || scene_key_admits(key, value);
    const int is_tiny = form && !whole && fabs(value) < SMALLEST && !is_zero(node->value);
    char *word = or_word(key), *range = key ? scene_key_range(key) : NULL, *unit = scene_key_in_units(key);
    if (!form)
        SCENE_WALK_PROBLEM(value, w, node, path, "must be a %s%s%s%s%s", whole ? "whole number" : "number",
                           range ? ", " : "", range ? range : "", unit, word);
    else if (!admitted)
        SCENE_WALK_PROBLEM(value, w, node, path, "must be %s%s", range, word);
    else if (fabs(value) > largest && whole)
        SCENE_WALK_PROBLEM(value, w, node, path, "is too large");
    else if (fabs(value) > largest)
        SCENE_WALK_PROBLEM(value, w, node, path, "is too large: at most %g", largest);
    else if (is_tiny)
        SCENE_WALK_PROBLEM(value, w, node, path, "is too small: must be 0 or at least %g in magnitude", SMALLEST);
    free(word);
    free(range);
    free(unit);
    return form && admitted && fabs(value) <= largest && !is_tiny;
}

/* Why a value of earlier scenes is no longer there, or NULL. */
static const char *why_gone(const char *path, const char *value) {
    return strcmp(path, "coupling.load") || strcmp(value, "wall")
               ? NULL
               : "no longer a load, leave it out: reaction, the default, goes with crack_fluid and with "
                 "fluid.diffusion: implicit too";
}

int scene_walk_scalar_choice(struct scene_walk *w, struct scene_node *node, const struct scene_value *v,
                             const char *path) {
    const char *word[SCENE_WALK_KEYS];
    const int dimension = w->dimension == 2 ? SCENE_IN_PLATE : w->dimension == 3 ? SCENE_IN_3D : ~0;
    const int plain = node->kind == SCENE_NODE_SCALAR;
    int n = 0, elsewhere = 0;
    ENSURE(v->most <= SCENE_WALK_KEYS, "%s has %d choices", path, v->most);
    for (int i = 0; i < v->most; i++) {
        const char *its = v->words[i].word;
        const int here = !v->words[i].only || v->words[i].only & dimension, is = plain && !strcmp(node->value, its);
        if (here && is) return 1;
        if (here) word[n++] = its;
        elsewhere |= is;
    }
    const char *gone = plain ? why_gone(path, node->value) : NULL;
    if (gone) {
        SCENE_WALK_PROBLEM(value, w, node, path, "%s", gone);
        return 0;
    }
    char *allowed = scene_key_joined(n, word);
    SCENE_WALK_PROBLEM(value, w, node, path, "must be %s%s%s", n > 1 ? "one of " : "", allowed,
                       elsewhere ? w->dimension == 2 ? " in a plate" : " in 3D"
                       : plain   ? scene_problem_hint(node->value, n, word).text
                                 : "");
    free(allowed);
    return 0;
}

int scene_walk_scalar_text(struct scene_walk *w, struct scene_node *node, const struct scene_value *v,
                           const char *path) {
    const size_t length = node->kind == SCENE_NODE_SCALAR ? strlen(node->value) : 0;
    if (node->kind != SCENE_NODE_SCALAR || length < (size_t)v->least)
        SCENE_WALK_PROBLEM(value, w, node, path, "must be a text%s",
                           length < (size_t)v->least && node->kind == SCENE_NODE_SCALAR ? ", is empty" : "");
    else if (sanitize_has_control(node->value))
        SCENE_WALK_PROBLEM(value, w, node, path, "must be one line without control characters");
    else if (length > (size_t)v->most)
        SCENE_WALK_PROBLEM(value, w, node, path, "is too long: %zu characters, at most %d", length, v->most);
    else
        return 1;
    return 0;
}
