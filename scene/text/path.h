/* Paths of keys: "solid.bodies[0].low". */
#pragma once

struct scene_path {
    char text[96];
};
/* A path made by a printf format. */
struct scene_path scene_path(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* PATH("solid.bodies[%d].low", b); AT is its text. */
#define PATH(...) scene_path(__VA_ARGS__)
#define AT(...) PATH(__VA_ARGS__).text
