/* Common to the fuzz targets. Each target reads one kind of a user's file from given bytes; libFuzzer makes the bytes,
 * or replay.c takes them from the corpus. The linker redirects die, die_all and ensure_failed to fuzz.c: after a
 * refusal the target continues, a failed ENSURE aborts. */
#pragma once
#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes);

/* Calls read(what); returns 0, or the exit code with which it would have ended the program. */
int fuzz_read(void (*read)(void *), void *what);
/* Writes these bytes to a file of the process, the same at each call; returns its path. */
const char *fuzz_file(const void *data, size_t bytes);
/* Aborts with a message if the condition is false. */
void fuzz_expect(int holds, const char *what);
