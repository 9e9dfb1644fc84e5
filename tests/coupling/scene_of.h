/* A scene from two pieces of text, read as the program reads its file. */
#pragma once
#include "base/par.h"
#include "scene/scene.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>

/* The sides of a fluid that is periodic in all directions; a part of a scene's text. */
#define SCENE_OF_PERIODIC_SIDES                                                                                        \
    "  sides:\n"                                                                                                       \
    "    x_low: {type: periodic}\n    x_high: {type: periodic}\n"                                                      \
    "    y_low: {type: periodic}\n    y_high: {type: periodic}\n"                                                      \
    "    z_low: {type: periodic}\n    z_high: {type: periodic}\n"

/* The scene of both texts, one after the other, with n settings. Free with scene_free. Collective. */
static inline struct scene *scene_of(const char *one, const char *two, int n, const char *const *set) {
    char path[] = "/tmp/frana_test_sceneXXXXXX";
    if (par_rank() == 0) {
        const int fd = mkstemp(path);
        check_at_least(fd, 0);
        assert_int_equal(write(fd, one, strlen(one)), (long)strlen(one));
        assert_int_equal(write(fd, two, strlen(two)), (long)strlen(two));
        close(fd);
    }
    par_bcast(path, sizeof path, 0);
    struct scene *scene = scene_new(path, n, set);
    par_barrier();
    if (par_rank() == 0) unlink(path);
    return scene;
}
