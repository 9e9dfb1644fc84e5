/* Parts of a study's file: each reads what stands under a key and says what is wrong with it. For study/file*.c only.
 */
#pragma once
#include "study/file/file.h"

enum { STUDY_RANKS_MAX = 1000000 };

void study_sets_read(struct study_sets *sets, const struct scene_node *mapping, const char *path,
                     struct scene_problems *problems);
void study_sets_join(struct study_sets *sets, const struct study_sets *more); /* copies of more at the end */
void study_sets_free(struct study_sets *sets);

/* A list of variants, or {product: [list, list, ...]}, of which every combination is one. */
void study_variants_read(struct study_variants *v, const struct scene_node *node, const char *path, int with_size,
                         struct scene_problems *problems);
void study_variants_free(struct study_variants *v);

void study_quantities_read(struct study *s, const struct scene_node *root, struct scene_problems *problems);
void study_quantities_free(struct study *s);
