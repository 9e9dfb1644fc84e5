/* ENSURE: checks a condition that only a bug of this program can break. */
#pragma once

/* If cond is false: prints rank, file, line and the message, and aborts all ranks. Not collective. */
#define ENSURE(cond, ...)                                                                                              \
    do {                                                                                                               \
        if (!(cond)) ensure_failed(__FILE__, __LINE__, #cond, __VA_ARGS__);                                            \
    } while (0)

_Noreturn void ensure_failed(const char *file, int line, const char *cond, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
