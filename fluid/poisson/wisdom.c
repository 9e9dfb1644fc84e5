/* Reads FFTW's measured plans from the user's cache folder and stores new ones there. */
#include "fluid/poisson/wisdom.h"
#include "base/par.h"
#include "base/files/cache.h"
#include "base/files/plain_file.h"

#include <fftw3.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FILE_MAX = 4 << 20 };

#define NAME "fftw.wisdom"

static char *known; /* FFTW's wisdom as text, as it was after loading */

static char *read_text(const char *path) {
    FILE *file = plain_file_read(path);
    if (!file) return NULL;
    char *text = malloc(FILE_MAX + 1);
    const size_t length = fread(text, 1, FILE_MAX + 1, file);
    fclose(file);
    if (length > 0 && length <= FILE_MAX) {
        text[length] = '\0';
        return text;
    }
    free(text);
    return NULL;
}

void fluid_wisdom_load(void) {
    char path[CACHE_PATH], *text = NULL;
    long length = 0;
    if (par_rank() == 0 && cache_path(path, NAME, 0)) text = read_text(path);
    if (text) length = (long)strlen(text) + 1;
    par_bcast(&length, sizeof length, 0);
    if (length > 0 && !text) text = malloc((size_t)length);
    par_bcast(text, (size_t)length, 0);
    if (text)
        fftw_import_wisdom_from_string(text); /* FFTW refuses a text of another version or a broken one as a whole;
                                               * plans are then measured */
    free(text);
    free(known);
    known = fftw_export_wisdom_to_string();
}

void fluid_wisdom_store(void) {
    struct cache_file file;
    if (par_rank() != 0) return;
    char *text = fftw_export_wisdom_to_string();
    if (text && !(known && strcmp(text, known) == 0) && cache_begin(&file, NAME)) {
        fputs(text, file.file);
        cache_end(&file);
    }
    free(text);
}
