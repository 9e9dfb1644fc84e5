/* Files and texts that a study reads back. */
#pragma once
#include "scene/text/node.h"

char *study_text_of(const char *path); /* the whole file, malloc'ed; NULL: unreadable */
/* The tree of a file in YAML (which includes JSON); NULL: missing or malformed. */
struct scene_node *study_text_tree(const char *path);
/* The number in a text, without blanks around it; NAN if it is no number. text may be NULL. */
double study_text_number(const char *text);
/* A text turned into a part of a file name: letters, digits, '.', '_' and '-' are kept, all else becomes '-';
 * malloc'ed, never empty. */
char *study_text_slug(const char *text);
