#include "tests/fuzz/fuzz.h"
#include "base/error.h"
#include "base/par.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

_Noreturn void __wrap_die(enum exit_code code, const char *format, ...);
_Noreturn void __wrap_die_all(enum exit_code code, const char *format, ...);
_Noreturn void __wrap_error_bug(const char *file, int line, const char *cond, const char *format, ...);

static jmp_buf *back;

static _Noreturn void leave(enum exit_code code, const char *format, va_list args) {
    char sentence[4096]; /* made and thrown away: its arguments are looked at */
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

void __wrap_error_bug(const char *file, int line, const char *cond, const char *format, ...) {
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

const char *fuzz_file(const void *data, size_t bytes) {
    static char path[64];
    static int fd = -1;
    if (fd < 0) {
        fd = memfd_create("fuzz", 0);
        snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    }
    fuzz_expect(ftruncate(fd, 0) == 0 && pwrite(fd, data, bytes, 0) == (ssize_t)bytes, "no memory for the file");
    return path;
}

void fuzz_expect(int holds, const char *sentence) {
    if (holds) return;
    fprintf(stderr, "fuzz: %s\n", sentence);
    abort();
}

int LLVMFuzzerInitialize(int *argc, char ***argv) {
    par_begin(argc, argv);
    atexit(par_end);
    return 0;
}
