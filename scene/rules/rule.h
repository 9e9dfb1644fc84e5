/* Units, ranges and defaults of the scene's keys, and where each applies. */
#pragma once
#include "scene/scene.h"

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

struct scene_rule {
    const char *path; /* with [] for any index and SIDE for the name of any side: fluid.sides.SIDE.type */
    const char *unit;
    const char *fallback;   /* the default, as YAML; NULL: none */
    double low, high;       /* range of a number, or of each number of a list; low == high: any */
    int open;               /* 1: low itself is not allowed; 2: high itself is not */
    const char *word;       /* a word allowed instead of a number */
    const char *load;       /* the value that the word stands for in the struct */
    int only;               /* enum scene_need bits: the key is allowed in scenes with these parts; 0: in any */
    int needed;             /* enum scene_need bits: the key is required in these scenes (if its sibling allows the
                             * key); others have the default */
    const char *sibling;    /* the key is allowed only if this key beside it ... */
    const char *values;     /* ... has one of these values */
    const char *with;       /* ... or if this one is given beside it */
    const char *not_with;   /* ... or if this one is not given */
    const char *in_plate;   /* the default in a plate, if it differs (vectors lose the third number in any case) */
    double plate_high;      /* upper end of the range in a plate, itself allowed; 0: the same as high */
    const char *choices[2]; /* the words of a choice in a plate and in a solid in 3D; NULL: all */
    const char *named[2]; /* for a list that may be written as a mapping: the keys of its entries that such a mapping's
                           * keys and values stand for, {1: quartz} for [{label: 1, material: quartz}] */
    const char *bare;     /* for a list whose entries may be bare lists: the key that such a list stands for, [x, y]
                           * for {at: [x, y]} */
};

extern const struct scene_rule scene_rule_table[]; /* ends with path NULL */
/* The rule of a path such as solid.bodies[0].radius, or NULL. */
const struct scene_rule *scene_rule_find(const char *path);
/* "greater than 0", "between -1 and 1", ...: malloc'ed; NULL for a rule without a range. */
char *scene_rule_range(const struct scene_rule *rule);
int scene_rule_admits(const struct scene_rule *rule, double value);
char *scene_rule_in_units(const struct scene_rule *rule); /* " (m)" where the key has a unit: malloc'ed */
