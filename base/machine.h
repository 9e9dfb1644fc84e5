/* What the program runs on. Not collective. */
#pragma once
#include <stddef.h>

/* The processor's model, as /proc/cpuinfo names it; the architecture where it does not. */
void machine_processor(char *to, size_t size);
int machine_cores(void); /* that are online */
