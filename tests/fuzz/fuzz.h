/* What the fuzz targets share. Each target reads one kind of a user's file from given bytes; libFuzzer makes the bytes,
 * or replay.c takes them from the corpus. The linker turns die, die_all and ensure_failed to fuzz.c: a refusal comes
 * back to the target, a bug of ours aborts. */
#pragma once
#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes);

/* Calls read(what); returns 0, or the exit code with which it would have ended the program. */
int fuzz_read(void (*read)(void *), void *what);
/* Writes these bytes to a file of the process, the same at each call; returns its path. */
const char *fuzz_file(const void *data, size_t bytes);
/* Aborts and says what is wrong where the condition does not hold. */
void fuzz_expect(int holds, const char *what);
