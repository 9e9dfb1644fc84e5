/* Units, ranges and defaults of the scene's keys, and where each applies. */
#pragma once
#include "scene/scene.h"

enum scene_need {
    SCENE_WITH_FLUID = 1,
    SCENE_WITH_SOLID = 2,
    SCENE_WITHOUT_FLUID = 4, /* only in a scene that has none */
    SCENE_ALWAYS = 8,
    SCENE_IN_3D = 16,
    SCENE_IN_PLATE = 32 /* domain.size has two numbers */
};

struct scene_rule {
    const char *path; /* with [] for any index, and SIDE for any side: fluid.sides.SIDE.type */
    const char *unit;
    const char *fallback;   /* the default, as YAML; NULL: none */
    double low, high;       /* range of a number, or of each in a list; low == high: any */
    int open;               /* 1: low itself is refused; 2: high is */
    const char *word;       /* a word allowed instead of a number */
    const char *load;       /* what the word stands for in the struct */
    int only;               /* enum scene_need bits: parts that the key makes sense with; 0: any */
    int needed;             /* enum scene_need bits: cannot be left out (of those, where its sibling admits it) */
    const char *sibling;    /* the key only makes sense where this one beside it ... */
    const char *values;     /* ... has one of these values */
    const char *with;       /* ... or where this one is given beside it */
    const char *not_with;   /* ... or where this one is not */
    const char *in_plate;   /* the default in a plate, where it is another (vectors lose the third number anyway) */
    double plate_high;      /* upper end of the range in a plate, itself allowed; 0: as high */
    const char *choices[2]; /* the words of a choice that a plate and a solid in 3D have; NULL: all */
    const char *bare;       /* the key of a list's entries that a list alone stands for: [x, y] for {at: [x, y]} */
};

extern const struct scene_rule scene_rule_table[]; /* ends with path NULL */
/* The rule of a path as solid.bodies[0].radius, or NULL. */
const struct scene_rule *scene_rule_find(const char *path);
/* "greater than 0", "between -1 and 1", ...: malloc'ed; NULL for a rule without a range. */
char *scene_rule_range(const struct scene_rule *rule);
int scene_rule_admits(const struct scene_rule *rule, double value);
char *scene_rule_in_units(const struct scene_rule *rule); /* " (m)" where the key has a unit: malloc'ed */
