/* Makes the path of a key from a format. */
#include "scene/text/path.h"

#include <stdarg.h>
#include <stdio.h>

struct scene_path scene_path(const char *format, ...) {
    struct scene_path path;
    va_list args;
    va_start(args, format);
    vsnprintf(path.text, sizeof path.text, format, args);
    va_end(args);
    return path;
}
