/* Reads a whole file as text. */
#include "base/files/read_file.h"
#include "base/die.h"
#include "base/files/plain_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

int read_file_is_special(const char *path) {
    struct stat is;
    return stat(path, &is) == 0 && !S_ISREG(is.st_mode);
}

char *read_file(const char *path) {
    FILE *in = plain_file_read(path);
    if (!in) return NULL;
    size_t bytes = 0, capacity = 1 << 14;
    char *text = malloc(capacity);
    for (size_t n = 1; text && n > 0;) {
        n = fread(text + bytes, 1, capacity - bytes - 1, in);
        bytes += n;
        if (bytes + 1 == capacity) text = realloc(text, capacity *= 2);
    }
    if (!text) die(EXIT_CODE_FILE, "%s: no memory left for %zu bytes", path, capacity);
    const int bad = ferror(in);
    fclose(in);
    text[bytes] = '\0';
    if (!bad) return text;
    free(text);
    return NULL;
}
