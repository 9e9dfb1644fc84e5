/* Fuzz target: the superblock of an HDF5 file, as it is checked before HDF5 opens the file. HDF5 itself is not run. */
#include "base/files/image/formats.h"
#include "tests/fuzz/fuzz_image.h"

#include <fcntl.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t bytes) {
    struct image_source s = {.unit = "", .subject = "it"};
    const int fd = open(fuzz_image_file(data, bytes), O_RDONLY | O_CLOEXEC);
    const int fault = image_hdf5_check(&s, fd, (long long)bytes);
    close(fd);
    fuzz_expect(fault == (s.why[0] != '\0'), "no sentence says why the file is refused");
    fuzz_expect(fault || bytes >= 48, "a file that is no longer than a superblock is accepted");
    return 0;
}
