/* Texts of any length. */
#pragma once

/* A malloc'ed text, as printf. Dies (exit 4) without memory. Not collective. */
char *text_new(const char *format, ...) __attribute__((format(printf, 1, 2)));
