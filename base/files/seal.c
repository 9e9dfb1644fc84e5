/* Checksums of arrays, independent of how these are divided over ranks. */
#include "base/files/seal.h"
#include "base/ensure.h"

#include <string.h>

/* SplitMix64's finalizer of w, moved by the i-th multiple of its constant. */
static uint64_t mix(uint64_t i, uint64_t w) {
    uint64_t z = w + (i + 1) * UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

static uint64_t sum_words(const unsigned char *value, size_t words, uint64_t first) {
    uint64_t sum = 0;
    for (size_t k = 0; k < words; k++) {
        uint64_t w;
        memcpy(&w, value + 8 * k, 8);
        sum += mix(first + k, w);
    }
    return sum;
}

uint64_t seal_sum(const void *value, size_t rows, size_t row, uint64_t first) {
    const unsigned char *at = value;
    const size_t words = row / 8, left = row % 8, stride = words + (left > 0);
    if (left == 0) return sum_words(at, rows * words, first * words);
    uint64_t sum = 0;
    for (size_t r = 0; r < rows; r++, at += row) {
        uint64_t w = 0;
        for (size_t k = 0; k < left; k++) w |= (uint64_t)at[8 * words + k] << 8 * k;
        sum += sum_words(at, words, (first + r) * stride) + mix((first + r) * stride + words, w);
    }
    return sum;
}

void seal_add(struct seal *seal, const char *name, uint64_t at, uint64_t bytes, uint64_t row, uint64_t sum) {
    ENSURE(seal->arrays < SEAL_ARRAYS && strlen(name) < SEAL_NAME, "array %s, the %d-th of a file", name,
           (int)seal->arrays + 1);
    struct seal_array *a = &seal->array[seal->arrays++];
    *a = (struct seal_array){.at = at, .bytes = bytes, .row = row, .sum = sum};
    strcpy(a->name, name);
}

const struct seal_array *seal_find(const struct seal *seal, const char *name) {
    for (uint64_t k = 0; k < seal->arrays; k++)
        if (!strcmp(seal->array[k].name, name)) return &seal->array[k];
    return NULL;
}
