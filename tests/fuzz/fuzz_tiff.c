/* Fuzz target: a TIFF, opened and read. */
#include "tests/fuzz/fuzz_image.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes) {
    fuzz_image(FILES_IMAGE_TIFF, data, bytes);
    return 0;
}
