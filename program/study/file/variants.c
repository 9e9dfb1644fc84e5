/* Reads the methods and levels of a study's file: a list, or the product of several lists. */
#include "base/arena.h"
#include "program/study/file/key.h"
#include "program/study/file/parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { VARIANTS_MAX = 1000 };

void study_variants_add(struct study_variants *v, const struct study_variant *more) {
    v->variant = arena_grown(v->variant, (size_t)v->n, sizeof *v->variant);
    v->variant[v->n++] = *more;
}

static struct study_variant *add(struct study_variants *v) {
    study_variants_add(v, &(struct study_variant){.size = NAN, .at = NAN});
    return &v->variant[v->n - 1];
}

static void read_variant(struct study_variant *v, const struct study_key *k, int with_size) {
    static const char *const word[] = {"name", "set", "ranks", "size"};
    v->line = k->mapping->line;
    if (study_key_known(k, with_size ? 4 : 3, word)) {
        const struct scene_node *set = scene_node_child(k->mapping, "set");
        study_key_missing(k, "name", "what it is called in tables and plots");
        v->name = study_key_text(k, "name", "");
        v->ranks = study_key_whole(k, "ranks", 1, STUDY_RANKS_MAX, 0);
        v->size = study_key_number(k, "size", STUDY_KEY_POSITIVE, NAN);
        if (set) study_sets_read(&v->sets, set, study_key_path(k, "set"), k->problems);
    } else {
        v->name = arena_text("%s", "");
    }
}

static void read_list(struct study_variants *v, const struct scene_node *list, const char *path, int with_size,
                      struct scene_problems *problems) {
    for (int i = 0; i < list->n; i++) {
        const struct study_key k = {list->child[i], arena_text("%s[%d]", path, i), problems};
        read_variant(add(v), &k, with_size);
    }
}

/* All pairs of an entry of a and an entry of b; a changes slowest. */
static void multiply(struct study_variants *a, const struct study_variants *b, const struct scene_node *node,
                     const char *path, struct scene_problems *problems) {
    struct study_variants product = {0};
    for (int i = 0; i < a->n; i++)
        for (int j = 0; j < b->n; j++) {
            const struct study_variant *x = &a->variant[i], *y = &b->variant[j];
            struct study_variant *p = add(&product);
            p->line = y->line;
            p->name = arena_text("%s %s", x->name, y->name);
            p->ranks = y->ranks ? y->ranks : x->ranks;
            p->size = isnan(x->size) ? y->size : x->size;
            study_sets_join(&p->sets, &x->sets);
            study_sets_join(&p->sets, &y->sets);
            if (!isnan(x->size) && !isnan(y->size) && i + j == 0)
                scene_problem_key(problems, node, path, "size is given in two lists of the product: give it in one");
        }
    *a = product;
}

static void read_product(struct study_variants *v, const struct scene_node *node, const char *path, int with_size,
                         struct scene_problems *problems) {
    static const char *const word[] = {"product"};
    const struct study_key k = {node, path, problems};
    if (!study_key_known(&k, 1, word)) return;
    const struct scene_node *lists = study_key_list(&k, "product", 1);
    for (int i = 0; lists && i < lists->n; i++) {
        char *its = arena_text("%s.product[%d]", path, i);
        struct study_variants factor = {0};
        if (lists->child[i]->kind != SCENE_NODE_LIST || lists->child[i]->n == 0)
            scene_problem_value(problems, lists->child[i], its, "must be a list that is not empty");
        else
            read_list(&factor, lists->child[i], its, with_size, problems);
        if (i == 0) {
            *v = factor;
        } else if ((long)v->n * factor.n > VARIANTS_MAX) {
            scene_problem_key(problems, lists, path, "the product has more than %d entries", VARIANTS_MAX);
        } else {
            multiply(v, &factor, lists, path, problems);
        }
    }
}

/* Checks the sizes: all variants or none have one, and none is larger than the one before. */
static void check_sizes(const struct study_variants *v, const struct scene_node *node, const char *path,
                        struct scene_problems *problems) {
    for (int i = 1; i < v->n; i++) {
        const struct study_variant *x = &v->variant[i - 1], *y = &v->variant[i];
        const struct scene_node place = {.kind = SCENE_NODE_MAPPING, .line = y->line};
        if (isnan(x->size) != isnan(y->size)) {
            scene_problem_key(problems, node, path, "give size for all or for none");
            return;
        }
        if (y->size > x->size) {
            scene_problem_key(problems, &place, path, "must go from coarse to fine: size %g follows %g", y->size,
                              x->size);
            return;
        }
    }
}

void study_variants_read(struct study_variants *v, const struct scene_node *node, const char *path, int with_size,
                         struct scene_problems *problems) {
    if (node->kind == SCENE_NODE_MAPPING)
        read_product(v, node, path, with_size, problems);
    else if (node->kind == SCENE_NODE_LIST && node->n > 0)
        read_list(v, node, path, with_size, problems);
    else
        scene_problem_value(problems, node, path, "must be a list that is not empty, or {product: [...]}");
    if (v->n > VARIANTS_MAX)
        scene_problem_key(problems, node, path, "has %d entries, more than %d", v->n, VARIANTS_MAX);
    for (int i = 0; i < v->n; i++)
        for (int j = 0; j < i; j++)
            if (*v->variant[i].name && !strcmp(v->variant[i].name, v->variant[j].name)) {
                const struct scene_node place = {.kind = SCENE_NODE_MAPPING, .line = v->variant[i].line};
                scene_problem_key(problems, &place, path, "two are called %s", v->variant[i].name);
                break;
            }
    check_sizes(v, node, path, problems);
}
