/* Buffers of doubles that grow. */
#include "base/memory.h"
#include "ibm/state.h"

void ibm_buffer_reserve(double **buffer, size_t *size, size_t wanted) {
    if (wanted <= *size) return;
    memory_free(*buffer);
    *size = wanted + wanted / 4;
    *buffer = memory_new(MEMORY_IBM, *size, sizeof(double));
}
