/* Our own bug: ENSURE. */
#pragma once

/* Our own bug: aborts with rank, file, line. Not collective. */
#define ENSURE(cond, ...)                                                                                              \
    do {                                                                                                               \
        if (!(cond)) ensure_failed(__FILE__, __LINE__, #cond, __VA_ARGS__);                                            \
    } while (0)

_Noreturn void ensure_failed(const char *file, int line, const char *cond, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
