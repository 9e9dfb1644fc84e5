/* The processor of this machine. Not collective. */
#pragma once
#include <stddef.h>

/* The processor's model name from /proc/cpuinfo; without it, the architecture. */
void machine_processor(char *to, size_t size);
int machine_cores(void);     /* cores that are online */
size_t machine_memory(void); /* bytes of memory that this process may use: the machine's, or the limit of a cgroup */
/* The smallest memory limit of the control groups of a process and of all above them, bytes; SIZE_MAX: none.
 * groups: /proc/self/cgroup; mounted: /sys/fs/cgroup, of version 1 (memory/PATH/memory.limit_in_bytes) or 2
 * (PATH/memory.max). A batch system or a container sets them. */
size_t machine_memory_limit(const char *groups, const char *mounted);
