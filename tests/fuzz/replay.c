/* Runs a fuzz target on every file of the given folders, in place of libFuzzer. */
#include "tests/fuzz/fuzz.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>

static void replay(const char *path) {
    FILE *in = fopen(path, "rb");
    if (!in) return;
    uint8_t *data = NULL;
    size_t bytes = 0, got, capacity = 0;
    do {
        data = realloc(data, capacity += 65536);
        fuzz_expect(data != NULL, "no memory");
        bytes += got = fread(data + bytes, 1, capacity - bytes, in);
    } while (got > 0);
    fclose(in);
    data = realloc(data, bytes + !bytes); /* so that a step past the end is seen */
    LLVMFuzzerTestOneInput(data, bytes);
    free(data);
}

int main(int argc, char **argv) {
    int files = 0;
    LLVMFuzzerInitialize(&argc, &argv);
    for (int i = 1; i < argc; i++) {
        DIR *folder = opendir(argv[i]);
        for (struct dirent *entry; folder && (entry = readdir(folder));) {
            char path[4096];
            if (entry->d_name[0] == '.') continue;
            snprintf(path, sizeof path, "%s/%s", argv[i], entry->d_name);
            printf("%s\n", path);
            fflush(stdout);
            replay(path);
            files++;
        }
        if (folder) closedir(folder);
    }
    printf("%d files\n", files);
    return files == 0;
}
