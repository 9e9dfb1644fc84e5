/* Shared part of the fuzz targets: die and die_all return to the target instead of ending the program. */
#include "base/die.h"
#include "base/ensure.h"
#include "base/par.h"
#include "tests/fuzz/fuzz.h"

#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

_Noreturn void __wrap_die(enum exit_code code, const char *format, ...);
_Noreturn void __wrap_die_all(enum exit_code code, const char *format, ...);
_Noreturn void __wrap_ensure_failed(const char *file, int line, const char *cond, const char *format, ...);

static jmp_buf *back;
static char sentence[4096]; /* of the last refusal */

static _Noreturn void leave(enum exit_code code, const char *format, va_list args) {
    vsnprintf(sentence, sizeof sentence, format, args);
    if (back) longjmp(*back, code);
    fprintf(stderr, "%s\n", sentence);
    abort();
}

void __wrap_die(enum exit_code code, const char *format, ...) {
    va_list args;
    va_start(args, format);
    leave(code, format, args);
}

void __wrap_die_all(enum exit_code code, const char *format, ...) {
    va_list args;
    va_start(args, format);
    leave(code, format, args);
}

void __wrap_ensure_failed(const char *file, int line, const char *cond, const char *format, ...) {
    va_list args;
    va_start(args, format);
    fprintf(stderr, "bug at %s:%d: %s: ", file, line, cond);
    vfprintf(stderr, format, args);
    abort();
}

int fuzz_read(void (*read)(void *), void *what) {
    jmp_buf here;
    const int code = setjmp(here);
    back = code ? NULL : &here;
    if (!code) read(what);
    back = NULL;
    return code;
}

/* The folder and the name are this process's own: HDF5 follows links. */
static char folder[] = "/tmp/fuzz_XXXXXX", file[32];

static void remove_file(void) {
    unlink(file);
    rmdir(folder);
}

const char *fuzz_file(const void *data, size_t bytes) {
    static int fd = -1;
    if (fd < 0) {
        fuzz_expect(mkdtemp(folder) != NULL, "no folder can be made in /tmp");
        snprintf(file, sizeof file, "%s/file", folder);
        fd = open(file, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        atexit(remove_file);
    }
    fuzz_expect(ftruncate(fd, 0) == 0 && pwrite(fd, data, bytes, 0) == (ssize_t)bytes, "no room in /tmp");
    return file;
}

void fuzz_expect(int holds, const char *what) {
    if (holds) return;
    fprintf(stderr, "fuzz: %s; the last refusal: %s\n", what, sentence);
    abort();
}

/* A function of LeakSanitizer, if that is linked. */
void __lsan_disable(void) __attribute__((weak));
void __lsan_enable(void) __attribute__((weak));

/* MPI_Finalize is not called: memory held by MPI's modules would look like leaks once they are unloaded. Leaks of
 * MPI_Init are not tested. */
int LLVMFuzzerInitialize(int *argc, char ***argv) {
    if (__lsan_disable) __lsan_disable();
    par_begin(argc, argv);
    if (__lsan_enable) __lsan_enable();
    return 0;
}
