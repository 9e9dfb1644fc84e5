/* The processor of this machine. Not collective. */
#pragma once
#include <stddef.h>

/* The processor's model name from /proc/cpuinfo; without it, the architecture. */
void machine_processor(char *to, size_t size);
int machine_cores(void);     /* cores that are online */
size_t machine_memory(void); /* bytes of memory */
