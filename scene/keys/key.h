/* A key of the scene: its name, its type, the member it loads into, its unit, range and default, and where it applies.
 * The tables of the keys, one a section, are scene/keys/table_*.c. */
#pragma once
#include "scene/scene.h"

enum scene_type {
    SCENE_NUMBER,
    SCENE_WHOLE,
    SCENE_SWITCH, /* true or false */
    SCENE_CHOICE, /* one of some words */
    SCENE_TEXT,
    SCENE_VECTOR, /* a list with a fixed number of entries; of 3 numbers, a plate has 2 */
    SCENE_LIST,
    SCENE_SECTION
};

enum scene_need {
    SCENE_WITH_FLUID = 1,
    SCENE_WITH_SOLID = 2,
    SCENE_WITHOUT_FLUID = 4, /* only in a scene without fluid */
    SCENE_ALWAYS = 8,
    SCENE_IN_3D = 16,
    SCENE_IN_PLATE = 32, /* domain.size has two numbers */
    SCENE_STEPPED = 64,  /* stepped through stages; other scenes are solved at once */
    SCENE_GALERKIN = 128 /* solid.method is element_free */
};

/* A word of a choice. */
struct scene_word {
    const char *word;
    int value;         /* in the struct */
    int only;          /* SCENE_IN_3D, SCENE_IN_PLATE; 0: in both */
    const char *takes; /* keys beside the choice that this word needs or allows, for keys with SCENE_BY_WORD */
};

struct scene_key;
struct scene_value {
    enum scene_type type;
    size_t bytes;                    /* in the struct; of an allocated value those of what is allocated */
    int least, most;                 /* entries of a vector or a list; characters of a text; most: words of a choice */
    const struct scene_word *words;  /* of a choice */
    const struct scene_value *entry; /* of a vector or a list */
    int repeats;                     /* of a vector: a single entry may stand for all of them */
    const struct scene_key *keys;    /* of a section; ends with name NULL */
    size_t count;                    /* of a list: where the number of its entries stands in the struct */
    int is_allocated;                /* of a section: the struct holds a pointer, NULL without the section */
};

#define SCENE_BY_WORD "" /* value of scene_key.values: the words of the sibling that take this key */

struct scene_key {
    const char *name;
    size_t offset; /* in the struct of the section */
    struct scene_value value;
    const char *unit;
    const char *fallback; /* the default, as YAML; NULL: none */
    double low, high;     /* range of a number, or of each number of a vector; low == high: any */
    int open;             /* 1: low itself is not allowed; 2: high itself is not */
    const char *word;     /* a word allowed instead of a number */
    double word_value;    /* the number that the word stands for */
    int only;             /* enum scene_need bits: the key is allowed in scenes with these parts; 0: in any */
    int needed;           /* enum scene_need bits: the key is required in these scenes (if the keys beside it allow it);
                           * others have the default */
    const char *sibling;  /* the key is allowed only if this key beside it ... */
    const char *values;   /* ... has one of these values */
    const char *with;     /* ... or if this one is given beside it */
    const char *not_with; /* ... or if this one is not given */
    const char *in_plate; /* the default in a plate, if it differs (vectors lose the third number in any case) */
    double plate_high;    /* upper end of the range in a plate, itself allowed; 0: the same as high */
    const char *named[2]; /* of a list that may be written as a mapping: the keys of its entries that such a mapping's
                           * keys and values stand for, {1: quartz} for [{label: 1, material: quartz}] */
    const char *bare;     /* of a list whose entries may be bare lists: the key that such a list stands for, [x, y]
                           * for {at: [x, y]} */
    const char *described; /* the key's name in docs/scene.md, if several keys are described as one: SIDE */
};

extern const struct scene_value scene_table_scene; /* the whole file: a section, allocated */

/* The key at a path such as solid.bodies[0].radius, or NULL. If described is not NULL, *described is the path in
 * docs/scene.md, solid.bodies[].radius: malloc'ed; NULL if there is no such key. */
const struct scene_key *scene_key_find(const char *path, char **described);
/* "path.name", of the name in docs/scene.md: malloc'ed. */
char *scene_key_path(const char *path, const struct scene_key *key);
const struct scene_key *scene_key_beside(const struct scene_key *keys, const char *name); /* NULL: none */
/* The values of its sibling with which the key is allowed, "sphere cylinder": malloc'ed. keys: its section. */
char *scene_key_values(const struct scene_key *keys, const struct scene_key *key);
/* The words of a choice in a plate and in 3D, "x y": malloc'ed; NULL if all words are allowed in both. */
char *scene_key_words(const struct scene_key *key, enum scene_need dimension);
int scene_key_is_among(const char *word, const char *list); /* list: as "a b c" */
char *scene_key_joined(int n, const char *const *name);     /* "a, b, c": malloc'ed */
/* Whether the key is needed in each scene with its section. */
int scene_key_is_needed(const struct scene_key *key);

/* "greater than 0", "between -1 and 1", ...: malloc'ed; NULL for a key without a range. */
char *scene_key_range(const struct scene_key *key);
int scene_key_admits(const struct scene_key *key, double value);
char *scene_key_in_units(const struct scene_key *key); /* " (m)" where the key has a unit: malloc'ed */
