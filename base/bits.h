/* Bits of arrays of bytes. */
#pragma once
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* How many of n bytes' bits are set. */
static inline long bits_count(const uint8_t *bits, size_t n) {
    long count = 0;
    size_t i = 0;
    for (; i + 8 <= n; i += 8) {
        uint64_t word;
        memcpy(&word, bits + i, sizeof word);
        count += __builtin_popcountll(word);
    }
    for (; i < n; i++) count += __builtin_popcount(bits[i]);
    return count;
}
