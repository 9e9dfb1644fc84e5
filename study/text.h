/* Files and texts that a study reads back. */
#pragma once
#include "scene/text/node.h"

char *study_text_of(const char *path); /* the whole file, malloc'ed; NULL: cannot be had */
/* A file in YAML, of which JSON is a part, as a tree; NULL: missing or malformed. */
struct scene_node *study_text_tree(const char *path);
/* The number that the text is, blanks around it apart; NAN where it is none. text may be NULL. */
double study_text_number(const char *text);
/* A word for a file's name: letters, digits, '.', '_' and '-', all else becomes '-'; malloc'ed, never empty. */
char *study_text_slug(const char *text);
