/* Disjoint sets of 0 .. n-1 as trees: parent[i] is another element of the set of i, at its root i itself. Each begins
 * alone, with parent[i] = i. The root is the smallest element of the set. */
#pragma once

/* Halves the way to the root. */
static inline long sets_root(long *parent, long i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/* The same for fewer than 2^31 elements. */
static inline int sets_root_int(int *parent, int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/* Unites the sets of a and b. Returns the root. */
static inline int sets_join_int(int *parent, int a, int b) {
    a = sets_root_int(parent, a);
    b = sets_root_int(parent, b);
    const int root = a < b ? a : b;
    return parent[a] = parent[b] = root;
}
