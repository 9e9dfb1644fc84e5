/* Names of the domain's six sides, as scenes have them. */
#pragma once

extern const char *const side_name[3][2]; /* [direction][low, high]: x_low, ... */
