/* Fuzz target: a NRRD, its header read from memory; the file itself where the header holds. */
#include "base/files/image/formats.h"
#include "tests/fuzz/fuzz_image.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes) {
    struct image_source s = {.unit = ""};
    struct image_header h;
    if (image_nrrd_parse(&s, (const char *)data, bytes, &h)) {
        fuzz_expect(s.why[0] != '\0', "no sentence says why the header is refused");
        return 0;
    }
    fuzz_expect(s.type > FILES_IMAGE_HEADER && s.type < FILES_IMAGE_TYPES, "a type that is none");
    fuzz_expect(h.bytes <= bytes && h.skip >= -1 && h.lines >= 0, "voxels that begin nowhere");
    if (!h.data[0]) fuzz_image(FILES_IMAGE_NRRD, data, bytes); /* no other file is opened */
    return 0;
}
