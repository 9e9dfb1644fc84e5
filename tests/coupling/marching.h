/* A run that a test marches through, step by step, as the program does. */
#pragma once
#include "coupling/control/watch.h"
#include "coupling/march.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/coupling/scene_of.h"

struct marching {
    struct scene *scene;
    struct run *r;
    struct march *march;
    struct step_status status; /* why the run has ended */
};

/* The run of the scene of both texts with n settings (scene_of). Collective, as all functions here. */
static inline struct marching marching_new(const char *one, const char *two, int n, const char *const *set) {
    struct scene *scene = scene_of(one, two, n, set);
    struct run *r = run_new(scene);
    return (struct marching){.scene = scene, .r = r, .march = march_new(r)};
}

/* Begins its first stage; balances are watched from here on. */
static inline void marching_begin(struct marching *q) {
    step_begin_stage(q->r);
    watch_begin(q->r);
    march_begin(q->march);
}

/* Takes a step, which must succeed. */
static inline void marching_take(struct marching *q) {
    const struct march_caller caller = {0};
    assert_int_equal(march_step(q->march, 0, &caller, &q->status), MARCH_DONE);
}

/* Takes a step and saves its state. Returns 0 if the watch ends the run there. */
static inline int marching_step(struct marching *q) {
    marching_take(q);
    return march_save_state(q->march, &q->status);
}

static inline void marching_free(struct marching *q) {
    march_free(q->march);
    run_free(q->r);
    scene_free(q->scene);
}
