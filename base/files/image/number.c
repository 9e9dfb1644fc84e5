/* Numbers of any type and byte order become doubles. */
#include "base/files/image/formats.h"
#include "base/ensure.h"

#include <stdint.h>
#include <string.h>

static const struct {
    const char *word;
    int bytes;
} type_of[FILES_IMAGE_TYPES] = {
    [FILES_IMAGE_HEADER] = {"auto", 0},     [FILES_IMAGE_INT8] = {"int8", 1},      [FILES_IMAGE_UINT8] = {"uint8", 1},
    [FILES_IMAGE_INT16] = {"int16", 2},     [FILES_IMAGE_UINT16] = {"uint16", 2},  [FILES_IMAGE_INT32] = {"int32", 4},
    [FILES_IMAGE_UINT32] = {"uint32", 4},   [FILES_IMAGE_INT64] = {"int64", 8},    [FILES_IMAGE_UINT64] = {"uint64", 8},
    [FILES_IMAGE_FLOAT32] = {"float32", 4}, [FILES_IMAGE_FLOAT64] = {"float64", 8}};

const char *image_number_word(enum files_image_type type) { return type_of[type].word; }

int image_number_bytes(enum files_image_type type) { return type_of[type].bytes; }

int image_number_is_swapped(enum files_image_order order) {
    return (order == FILES_IMAGE_BIG) != (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__);
}

/* Bytes to a double: WORD holds them, NUMBER is what they mean. */
#define CONVERT(WORD, NUMBER, SWAP)                                                                                    \
    for (long i = 0; i < n; i++) {                                                                                     \
        WORD word;                                                                                                     \
        NUMBER number;                                                                                                 \
        memcpy(&word, (const char *)bytes + i * (long)sizeof word, sizeof word);                                       \
        if (swapped) word = SWAP(word);                                                                                \
        memcpy(&number, &word, sizeof number);                                                                         \
        value[i] = (double)number;                                                                                     \
    }                                                                                                                  \
    return;
#define SAME(word) (word)

void image_number_convert(enum files_image_type type, int swapped, const void *bytes, long n, double *value) {
    switch (type) {
    case FILES_IMAGE_INT8:
        CONVERT(uint8_t, int8_t, SAME)
    case FILES_IMAGE_UINT8:
        CONVERT(uint8_t, uint8_t, SAME)
    case FILES_IMAGE_INT16:
        CONVERT(uint16_t, int16_t, __builtin_bswap16)
    case FILES_IMAGE_UINT16:
        CONVERT(uint16_t, uint16_t, __builtin_bswap16)
    case FILES_IMAGE_INT32:
        CONVERT(uint32_t, int32_t, __builtin_bswap32)
    case FILES_IMAGE_UINT32:
        CONVERT(uint32_t, uint32_t, __builtin_bswap32)
    case FILES_IMAGE_INT64:
        CONVERT(uint64_t, int64_t, __builtin_bswap64)
    case FILES_IMAGE_UINT64:
        CONVERT(uint64_t, uint64_t, __builtin_bswap64)
    case FILES_IMAGE_FLOAT32:
        CONVERT(uint32_t, float, __builtin_bswap32)
    case FILES_IMAGE_FLOAT64:
        CONVERT(uint64_t, double, __builtin_bswap64)
    case FILES_IMAGE_HEADER:
    case FILES_IMAGE_TYPES:
        break;
    }
    ENSURE(0, "type %d", (int)type);
}
