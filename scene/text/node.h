/* A scene as written: a tree of mappings, lists and scalars that knows the line of each key. */
#pragma once
#include <stddef.h>

enum scene_node_kind { SCENE_NODE_SCALAR, SCENE_NODE_LIST, SCENE_NODE_MAPPING };

struct scene_node {
    enum scene_node_kind kind;
    char *key;        /* in a mapping; NULL in a list; owned */
    char *value;      /* of a scalar; owned */
    int quoted;       /* the scalar stands in quotes: a text */
    int line;         /* from 1; 0: not in the file */
    char *set;        /* the path that a --set has named, where the node comes from one; owned */
    int set_inner;    /* 1: the node is a part of what the --set has given */
    int bad;          /* 1: a mistake was said of it; what it holds now only stands in for a value */
    const char *load; /* what stands for the word when it is loaded into the struct (auto: 0); borrowed */
    const char *pad;  /* what a list gets at its end when it is loaded (a plate's third component); borrowed */
    int n, capacity;
    struct scene_node **child; /* owned */
};

struct scene_node *scene_node_new(enum scene_node_kind kind, const char *key, const char *value);
void scene_node_free(struct scene_node *node);
void scene_node_clear(struct scene_node *node); /* frees what it holds; its key, line and origin stay */
void scene_node_insert(struct scene_node *parent, int i, struct scene_node *child); /* before the i-th; takes it */
void scene_node_append(struct scene_node *parent, struct scene_node *child);        /* takes the child */
void scene_node_drop(struct scene_node *parent, int i);

struct scene_node *scene_node_child(const struct scene_node *mapping, const char *key); /* NULL: none */
/* The node at a path as solid.bodies[0].radius; NULL if there is none. */
struct scene_node *scene_node_find(const struct scene_node *root, const char *path);
/* The node at the path, or the deepest of its ancestors that is there. */
const struct scene_node *scene_node_near(const struct scene_node *root, const char *path);
/* Whether the path is there and no mistake was found in it or below. */
int scene_node_is_clean(const struct scene_node *root, const char *path);
