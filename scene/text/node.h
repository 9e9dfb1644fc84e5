/* A scene as written: a tree of mappings, lists and scalars, with the line of each key. */
#pragma once
#include <stddef.h>

enum scene_node_kind { SCENE_NODE_SCALAR, SCENE_NODE_LIST, SCENE_NODE_MAPPING };

struct scene_node {
    enum scene_node_kind kind;
    char *key;     /* in a mapping; NULL in a list; owned */
    char *value;   /* of a scalar; owned */
    int quoted;    /* the scalar is in quotes: a text */
    int line;      /* from 1; 0: not from the file */
    char *set;     /* the path of the --set that the node comes from; owned */
    int set_inner; /* 1: the node is inside a value given by --set */
    int bad;       /* 1: a mistake of this node was reported; its value is a replacement */
    int n, capacity;
    struct scene_node **child; /* owned */
};

struct scene_node *scene_node_new(enum scene_node_kind kind, const char *key, const char *value);
void scene_node_free(struct scene_node *node);
void scene_node_clear(struct scene_node *node); /* frees its contents; its key, line and origin are kept */
void scene_node_insert(struct scene_node *parent, int i, struct scene_node *child); /* inserts before the i-th; takes
                                                                                     * ownership */
void scene_node_append(struct scene_node *parent, struct scene_node *child);        /* takes ownership */
void scene_node_drop(struct scene_node *parent, int i);

struct scene_node *scene_node_child(const struct scene_node *mapping, const char *key); /* NULL: none */
/* The node at a path such as solid.bodies[0].radius; NULL if there is none. */
struct scene_node *scene_node_find(const struct scene_node *root, const char *path);
/* The node at the path, or its deepest ancestor that exists. */
const struct scene_node *scene_node_near(const struct scene_node *root, const char *path);
/* Whether the path exists and neither it nor a node below it has a mistake. */
int scene_node_is_clean(const struct scene_node *root, const char *path);
