/* Forecasts time and memory of intrinsic.csv. */
#include "program/check/parts.h"
#include "base/par.h"
#include "base/print.h"
#include "coupling/interface/deposit.h"
#include "coupling/medium/intrinsic.h"
#include "coupling/setup/pores.h"
#include "program/output/amount.h"
#include "stokes/stokes.h"

#include <math.h>

#define MUCH 0.1 /* of the run's time */

/* Samples that are solved: of a rigid stage one, whose solution the others repeat. */
static long samples_of(const struct run *r) {
    long from = 0, samples = 0;
    for (int k = 0; k < r->scene->stages; k++) {
        const struct scene_stage *stage = &r->scene->stage[k];
        const long all = amount_samples(r, r->scene->output.permeability_every, from, from + stage->steps);
        samples += stage->solid == SCENE_SOLID_RIGID && all > 1 ? 1 : all;
        from += stage->steps;
    }
    return samples;
}

/* Seconds of a sample that starts from nothing. Collective. */
static double sample_seconds(struct medium_intrinsic *t, long pores, int solutions, int measured) {
    if (!measured) return 1e-6 * STOKES_MICROSECONDS * (double)pores * solutions / par_size();
    const double start = par_seconds();
    medium_intrinsic_measure(t);
    return par_max(par_seconds() - start);
}

void check_intrinsic_print_at_once(double pores, const char *others) {
    const double bytes = STOKES_BYTES * pores;
    print(
        "  %-10s frana permeability solves about %.3g pore cells with %.3g %s in %.2g s, and eight times as many on a "
        "grid twice as fine\n",
        "at once", pores, bytes < 1e9 ? 1e-6 * bytes : 1e-9 * bytes, bytes < 1e9 ? "MB" : "GB",
        3e-6 * STOKES_MICROSECONDS * pores / par_size());
    if (others) print("  %-10s %s of frana run, which steps the flow in time\n", "", others);
}

void check_intrinsic_print_rigid(const struct run *r) {
    const int *n = r->scene->domain.cells;
    double solid = 0, cell = 1;
    if (!r->medium || setup_pores_why(r->scene)) return;
    for (int h = 0; h < r->solid->n; h++) solid += r->solid->volume[h];
    for (int c = 0; c < 3; c++) cell *= r->scene->domain.size[c] / n[c];
    check_intrinsic_print_at_once(fmax((double)n[0] * n[1] * n[2] - par_sum(solid) / cell, 0), "the other lines are");
}

void check_intrinsic_print(struct run *r, double seconds, int measured) {
    const long every = r->scene->output.permeability_every;
    if (!r->medium || every == 0) return;
    struct medium_intrinsic *t = medium_intrinsic_new(r->medium, fluid_input_of(r->fluid));
    deposit_update(r);
    const long pores = medium_intrinsic_pores(t), samples = samples_of(r);
    const double one = sample_seconds(t, pores, 3, measured), all = one * (double)samples;
    print("  %-10s k every %ld steps: %ld times solved through %ld pore cells, with %.3g MB\n", "intrinsic", every,
          samples, pores, 1e-6 * medium_intrinsic_bytes(pores));
    print("  %-10s %.2g s each time from nothing, %s, and less from the time before: at most %.2g s", "", one,
          measured ? "measured now" : "an estimate", all);
    if (seconds > 0) print(", %.2g %% of the run's time", 100 * all / (all + seconds));
    print("\n");
    if (seconds > 0 && all > MUCH * (all + seconds))
        print(
            "  warning: output.permeability_every may take more than a tenth of the run's time; with %ld it does not\n",
            (long)ceil((double)every * all * (1 - MUCH) / (MUCH * seconds)));
    medium_intrinsic_free(t);
}
