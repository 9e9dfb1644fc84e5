/* Parts of a study's file: each reads the value of a key and reports its mistakes. Private to program/study/file. */
#pragma once
#include "program/study/file/file.h"

enum { STUDY_RANKS_MAX = 1000000 };

void study_sets_read(struct study_sets *sets, const struct scene_node *mapping, const char *path,
                     struct scene_problems *problems);
/* One setting of the key for each value of the list. */
void study_sets_read_values(struct study_sets *sets, const char *key, const struct scene_node *values, const char *path,
                            struct scene_problems *problems);
void study_sets_join(struct study_sets *sets, const struct study_sets *more); /* appends copies of more */

/* Reads a list of variants, or {product: [list, list, ...]}, which stands for all combinations of the lists'
 * entries. */
void study_variants_read(struct study_variants *v, const struct scene_node *node, const char *path, int with_size,
                         struct scene_problems *problems);

void study_variants_add(struct study_variants *v, const struct study_variant *more); /* takes what it owns */
/* Reads sweep: {key, values} or {points} into the levels, and what a sweep does not need: methods. */
void study_sweep_read(struct study *s, const struct scene_node *root, struct scene_problems *problems);

void study_quantities_read(struct study *s, const struct scene_node *root, struct scene_problems *problems);
int study_quantities_at(const char *word); /* enum study_at; -1: no such word */
