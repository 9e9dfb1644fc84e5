/* Keys of a mapping in a study's file, by type. A missing key gives the fallback; a wrong one is reported, with its
 * line, its value and what is allowed, and gives the fallback as well. path: of the mapping, "" for the file's own. */
#pragma once
#include "scene/text/problem.h"

struct study_key {
    const struct scene_node *mapping;
    const char *path;
    struct scene_problems *problems;
};

enum study_key_range { STUDY_KEY_ANY, STUDY_KEY_POSITIVE, STUDY_KEY_NOT_NEGATIVE };

/* Checks that every key is one of the words [n]. Returns 0 if the node is not a mapping, which is reported. */
int study_key_known(const struct study_key *k, int n, const char *const *word);
/* Whether the node is a finite decimal number and nothing else. */
int study_key_number_of(const struct scene_node *node, double *value);
double study_key_number(const struct study_key *k, const char *key, enum study_key_range range, double fallback);
int study_key_whole(const struct study_key *k, const char *key, int low, int high, int fallback);
int study_key_choice(const struct study_key *k, const char *key, int n, const char *const *word, int fallback);
int study_key_true(const struct study_key *k, const char *key); /* true is the only value allowed */
char *study_key_text(const struct study_key *k, const char *key, const char *fallback); /* fallback NULL: NULL */
/* A list that is not empty, or NULL. needed: a missing list is reported. */
const struct scene_node *study_key_list(const struct study_key *k, const char *key, int needed);
void study_key_missing(const struct study_key *k, const char *key, const char *what); /* reports the key if it is
                                                                                       * missing */
/* The whole path of a key below k. */
char *study_key_path(const struct study_key *k, const char *key);
