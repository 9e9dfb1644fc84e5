/* Text for the user on the standard output. */
#pragma once

/* printf on rank 0, nothing on the others. Not collective. */
void print(const char *format, ...) __attribute__((format(printf, 1, 2)));
