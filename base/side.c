/* Names of the domain's six sides. */
#include "base/side.h"

const char *const side_name[3][2] = {{"x_low", "x_high"}, {"y_low", "y_high"}, {"z_low", "z_high"}};
