/* Shared by store.c and store_read.c. */
#pragma once
#include "base/files/folder.h"
#include "base/files/h5.h"
#include "base/files/store.h"

struct store {
    struct h5 h5;
    char folder[FOLDER_PATH], name[256]; /* writing */
    int keep;
    int damaged; /* reading: an array had a wrong checksum */
    struct seal seal;
    double *scratch;
    size_t scratch_items;
};

hid_t store_h5_type(enum store_type type);
double *store_scratch(struct store *s, size_t items);
int store_is_contiguous(const struct store_block *block);
struct h5_block store_h5_block(const struct store_block *block);
struct h5_block store_h5_range(int comps, long n, long first, long count);
size_t store_row(enum store_type type, int comps); /* bytes of an item of a range */
/* This rank's part of a block's checksum; value: contiguous. */
uint64_t store_sum_block(const struct store_block *block, const double *value);
/* Names of the checkpoints in a folder, best first, malloc'ed. By one rank. */
int store_candidates(const char *folder, char (**name)[256]);
