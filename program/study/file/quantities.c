/* Reads the quantities and references of a study's file. */
#include "base/arena.h"
#include "program/study/file/key.h"
#include "program/study/file/parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define KNOWN(k, ...)                                                                                                  \
    study_key_known(k, (int)(sizeof((const char *const[]){__VA_ARGS__}) / sizeof(char *)),                             \
                    (const char *const[]){__VA_ARGS__})

static const double formal_order = 2; /* in space, of fluid and bonds; in time that of Verlet */
static const char *const at_words[STUDY_ATS] = {
    [STUDY_LAST] = "last", [STUDY_FIRST] = "first", [STUDY_MAX] = "max",          [STUDY_MIN] = "min",
    [STUDY_MEAN] = "mean", [STUDY_TIME] = "time",   [STUDY_TIME_MAX] = "time_max"};

static void read_reference(struct study_reference *r, const struct scene_node *node, const char *path,
                           struct scene_problems *problems) {
    const struct study_key k = {node, path, problems};
    r->scale = r->order = NAN;
    if (!KNOWN(&k, "value", "finest", "uncertainty", "scale", "source", "method", "order", "formal_order")) return;
    const int has_value = scene_node_child(node, "value") != NULL, finest = study_key_true(&k, "finest");
    r->kind = finest ? STUDY_REFERENCE_FINEST : STUDY_REFERENCE_VALUE;
    r->value = study_key_number(&k, "value", STUDY_KEY_ANY, 0);
    r->uncertainty = study_key_number(&k, "uncertainty", STUDY_KEY_NOT_NEGATIVE, 0);
    r->scale = study_key_number(&k, "scale", STUDY_KEY_POSITIVE, NAN);
    r->source = study_key_text(&k, "source", NULL);
    r->method = study_key_text(&k, "method", NULL);
    r->order = study_key_number(&k, "order", STUDY_KEY_POSITIVE, NAN);
    r->formal = study_key_number(&k, "formal_order", STUDY_KEY_POSITIVE, formal_order);
    const int has_formal = scene_node_child(node, "formal_order") != NULL;
    if (has_value == finest)
        scene_problem_key(problems, node, path, "needs value, or finest: true, and not both");
    else if (has_value && (r->method || !isnan(r->order)))
        scene_problem_key(problems, node, path, "method and order go with finest: true only");
    else if (has_formal && !isnan(r->order))
        scene_problem_key(problems, node, path, "order is given, so formal_order has nothing to limit");
    else if (finest && (r->uncertainty > 0 || r->source))
        scene_problem_key(problems, node, path, "uncertainty and source go with value only");
}

int study_quantities_at(const char *word) {
    for (int at = 0; at < STUDY_ATS; at++)
        if (!strcmp(word, at_words[at])) return at;
    return -1;
}

static void read_column(struct study_quantity *q, const struct study_key *k) {
    q->at = (enum study_at)study_key_choice(k, "at", STUDY_ATS, at_words, STUDY_LAST);
    q->after = study_key_number(k, "after", STUDY_KEY_ANY, -INFINITY);
    q->before = study_key_number(k, "before", STUDY_KEY_ANY, INFINITY);
    q->above = study_key_number(k, "above", STUDY_KEY_ANY, 0);
    q->where = study_key_text(k, "where", NULL);
    const int has_above = scene_node_child(k->mapping, "above") != NULL;
    if ((q->at == STUDY_TIME) != has_above)
        scene_problem_key(k->problems, k->mapping, k->path,
                          "above goes with at: time, the time when the column is first above it");
    if (q->after > q->before)
        scene_problem_key(k->problems, k->mapping, k->path, "after %g and before %g leave no time between", q->after,
                          q->before);
}

/* Reports keys that belong to another kind of quantity. */
static void refuse_others(const struct study_quantity *q, const struct study_key *k) {
    static const char *const of_series[] = {"at", "after", "before", "above", "where"};
    for (int i = 0; i < 5 && !q->column; i++)
        if (scene_node_child(k->mapping, of_series[i]))
            scene_problem_key(k->problems, k->mapping, k->path, "%s goes with column only", of_series[i]);
    if (q->row && q->column)
        scene_problem_key(k->problems, k->mapping, k->path, "give column or quantity, and not both");
    if (q->row && !q->file) scene_problem_key(k->problems, k->mapping, k->path, "quantity goes with file only");
    if (q->file && !q->row && !q->column)
        scene_problem_key(k->problems, k->mapping, k->path, "quantity is missing: which of the file's");
}

static void read_quantity(struct study_quantity *q, const struct scene_node *node, const char *path,
                          struct scene_problems *problems) {
    const struct study_key k = {node, path, problems};
    *q = (struct study_quantity){.line = node->line, .factor = 1};
    q->reference.scale = q->reference.order = NAN;
    q->reference.formal = formal_order;
    if (!KNOWN(&k, "name", "unit", "column", "at", "after", "before", "above", "where", "file", "quantity", "command",
               "factor", "reference"))
        return;
    q->column = study_key_text(&k, "column", NULL);
    q->file = study_key_text(&k, "file", NULL);
    q->row = study_key_text(&k, "quantity", NULL);
    q->command = study_key_text(&k, "command", NULL);
    q->factor = study_key_number(&k, "factor", STUDY_KEY_ANY, 1);
    q->unit = study_key_text(&k, "unit", "");
    q->name = study_key_text(&k, "name", q->column ? q->column : q->row ? q->row : "result");
    if ((q->column || q->file) + !!q->command != 1)
        scene_problem_key(problems, node, path, "needs one of column, file and command");
    else
        refuse_others(q, &k);
    if (q->column) read_column(q, &k);
    const struct scene_node *reference = scene_node_child(node, "reference");
    if (reference) read_reference(&q->reference, reference, study_key_path(&k, "reference"), problems);
}

/* A sweep compares with nothing. */
static void refuse_references(const struct study *s, const struct scene_node *root, struct scene_problems *problems) {
    const struct scene_node *node = scene_node_child(root, "reference");
    if (node) scene_problem_key(problems, node, "reference", "goes with levels: a sweep has no error");
    for (int i = 0; i < s->quantities; i++) {
        const struct scene_node place = {.kind = SCENE_NODE_MAPPING, .line = s->quantity[i].line};
        if (s->quantity[i].reference.kind != STUDY_REFERENCE_NONE)
            scene_problem_key(problems, &place, s->quantities > 1 ? "quantities" : "quantity",
                              "reference goes with levels: a sweep has no error");
    }
}

/* Gives the study's common reference to the quantities that have none of their own. */
static void share_reference(struct study *s, const struct scene_node *root, struct scene_problems *problems) {
    const struct scene_node *node = scene_node_child(root, "reference");
    for (int i = 0; i < s->quantities; i++) {
        struct study_reference *r = &s->quantity[i].reference;
        const struct scene_node place = {.kind = SCENE_NODE_MAPPING, .line = s->quantity[i].line};
        if (r->kind != STUDY_REFERENCE_NONE) continue;
        if (!node)
            scene_problem_key(problems, &place, s->quantities > 1 ? "quantities" : "reference",
                              "%s has no reference: {value: ..., source: ...} or {finest: true}",
                              s->quantity[i].name ? s->quantity[i].name : "it");
        else
            read_reference(r, node, "reference", problems);
    }
    const struct scene_node *value = node ? scene_node_find(node, "value") : NULL;
    if (value && s->quantities > 1)
        scene_problem_key(problems, node, "reference", "has one value for %d quantities: give each quantity its own",
                          s->quantities);
}

void study_quantities_read(struct study *s, const struct scene_node *root, struct scene_problems *problems) {
    const struct study_key k = {root, "", problems};
    const struct scene_node *one = scene_node_child(root, "quantity"), *many = study_key_list(&k, "quantities", 0);
    if (!one == !scene_node_child(root, "quantities")) {
        scene_problem_key(problems, one ? one : root, "quantity", "give quantity, or a list quantities, and not both");
        return;
    }
    if (!one && !many) return;
    s->quantities = one ? 1 : many->n;
    s->quantity = arena_new((size_t)s->quantities, sizeof *s->quantity);
    for (int i = 0; i < s->quantities; i++) {
        char *path = one ? arena_text("quantity") : arena_text("quantities[%d]", i);
        read_quantity(&s->quantity[i], one ? one : many->child[i], path, problems);
        for (int j = 0; j < i; j++)
            if (s->quantity[i].name && s->quantity[j].name && !strcmp(s->quantity[i].name, s->quantity[j].name))
                scene_problem_key(problems, many->child[i], path, "two are called %s", s->quantity[i].name);
    }
    if (s->is_sweep)
        refuse_references(s, root, problems);
    else
        share_reference(s, root, problems);
}
