/* Quasi-static growth of the cracks of an element-free plate by the maximum hoop stress.
 *
 * At each step the plate is solved under the scene's loads. K_I and K_II of each tip give the kink angle and K_eq
 * (physics/kink.h), and toughness over the largest K_eq is the factor of the loads at which a crack grows. The tip of
 * the largest K_eq, and those within a hundredth of it, move by `step`, and the next step begins. */
#pragma once
#include "coupling/setup/element_free.h"
#include "base/files/json.h"

struct element_free_growth_row {
    int step, tip;
    double x[2], along, kink; /* m; direction of the crack and angle to the next part, degrees */
    double k[2], k_eq;        /* Pa m^1/2 */
    double load;              /* factor of the loads */
    double length;            /* grown so far, m */
};
struct element_free_growth {
    int rows, room, steps;
    struct element_free_growth_row *row; /* [rows], owned */
    const char *end;                     /* why it ended */
};

/* Dies (exit 2) where the step or the radius does not fit the plate. Collective. */
void element_free_growth_check(const struct scene *scene, const struct galerkin *g);
/* Solves the plate, and again for each step: *g and its setup are replaced. Collective. */
void element_free_growth_run(struct element_free_growth *a, const struct scene *scene, struct setup_element_free *setup,
                             struct galerkin **g, void (*solve)(struct galerkin *g));
void element_free_growth_write(const struct element_free_growth *a, const char *folder); /* growth.csv. Collective */
void element_free_growth_record(const struct element_free_growth *a, struct json *j);    /* run.json. Rank 0 */
void element_free_growth_free(struct element_free_growth *a);
