/* Checks an HDF5 file's superblock by plain reading: HDF5 itself does not survive every damaged file. */
#include "base/files/image/formats.h"

#include <string.h>

/* Bytes of a superblock that are looked at: of version 1 with addresses of eight bytes, and its root group. */
enum { BYTES = 96, NEWEST = 3 };

struct superblock {
    const unsigned char *at;
    int version, address; /* bytes of an address */
    unsigned long long base, end, root;
};

static unsigned long long number_at(const unsigned char *at, int bytes) {
    unsigned long long value = 0;
    for (int b = bytes; b-- > 0;) value = value << 8 | at[b];
    return value;
}

static int is_size(int bytes) { return bytes == 2 || bytes == 4 || bytes == 8; }

/* Where the numbers stand is HDF5's file format, version 3.0, II.A. */
static int parse(struct image_source *s, struct superblock *b) {
    const unsigned char *at = b->at;
    b->version = at[8];
    if (b->version > NEWEST)
        return image_source_refuse(s, "its superblock has version %d, and 0 to %d are known", b->version, NEWEST);
    const int is_old = b->version < 2, lengths = is_old ? at[14] : at[10];
    const int first = is_old ? b->version == 0 ? 24 : 28 : 12;
    b->address = is_old ? at[13] : at[9];
    if (!is_size(b->address) || !is_size(lengths))
        return image_source_refuse(s, "its superblock is damaged: it has addresses of %d and lengths of %d bytes",
                                   b->address, lengths);
    b->base = number_at(at + first, b->address);
    b->end = number_at(at + first + 2 * b->address, b->address);
    b->root = number_at(at + first + (is_old ? 5 : 3) * b->address, b->address);
    return 0;
}

/* The header of the root group begins with its version, or with a word. */
static int check_root(struct image_source *s, int fd, const struct superblock *b) {
    unsigned char head[4];
    if (b->root >= b->end || b->base + b->root + sizeof head > b->end)
        return image_source_refuse(s, "its superblock is damaged: its root group is beyond its end");
    if (image_source_take(s, fd, (long long)(b->base + b->root), head, sizeof head)) return 1;
    if (head[0] == 1 || memcmp(head, "OHDR", 4) == 0) return 0;
    return image_source_refuse(s, "its root group is damaged");
}

int image_hdf5_check(struct image_source *s, int fd, long long bytes) {
    static const char signature[] = "\211HDF\r\n\032\n";
    unsigned char text[BYTES] = {0};
    long long place = 0;
    for (; place + 8 <= bytes; place = place ? 2 * place : 512) { /* others' bytes may be before it */
        if (image_source_take(s, fd, place, text, 8)) return 1;
        if (memcmp(text, signature, 8) == 0) break;
    }
    if (place + 8 > bytes) return image_source_refuse(s, "it is not an HDF5 file");
    if (bytes - place < BYTES / 2) return image_source_refuse(s, "it is truncated in its superblock");
    if (image_source_take(s, fd, place, text, bytes - place < BYTES ? (size_t)(bytes - place) : BYTES)) return 1;
    struct superblock b = {.at = text};
    if (parse(s, &b)) return 1;
    b.end += (unsigned long long)place - b.base; /* as HDF5 does where bytes were put before it, or taken away */
    b.base = (unsigned long long)place;
    if (b.end > (unsigned long long)bytes)
        return image_source_refuse(s, "it is truncated or damaged: its superblock says %llu bytes, and it has %lld",
                                   b.end, bytes);
    return check_root(s, fd, &b);
}
