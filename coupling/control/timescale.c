/* Says that a step of the fluid is so long for the solid that a run will hardly end, or that too many bonds break. */
#include "coupling/control/timescale.h"
#include "coupling/control/time_step.h"
#include "physics/dilatation.h"
#include "physics/waves.h"

#include <math.h>
#include <stdio.h>

/* Substeps in a step; the main case takes some ten. */
static const double COSTLY = 1000, HOPELESS = 10000;
/* Error by the fluid's step where bonds may break: excess of broken bonds, %, and how much too short the time is from
 * the stage's start until 1 % of the bonds are broken, %, by the fluid's step in stable steps of the solid (velocity
 * Verlet). Measured with a settled block of density ratio 3 (cases/verification/cost, bonds after 2.4 ms). */
enum { EXCESS_OF, EARLY_OF, ERRORS };
static const struct {
    double step, error[ERRORS];
} cost[] = {{0.8, {1.2, 0.3}},  {1.2, {2.2, 1.7}},   {2.4, {5.3, 6.4}},
            {4.8, {7.5, 10.7}}, {9.5, {10.9, 14.1}}, {19, {23.9, 23.3}}};
enum { COSTS = sizeof cost / sizeof *cost };
/* From this excess on there is a warning; what is advised. */
static const double EXCESS = 5, ADVISED = 2;

/* Linear interpolation in the logarithm of the step; beyond the ends the nearest line is continued, down to 0. */
static double error_of(double step, int of) {
    int k = 1;
    while (k < COSTS - 1 && step > cost[k].step) k++;
    const double slope = (cost[k].error[of] - cost[k - 1].error[of]) / log(cost[k].step / cost[k - 1].step);
    return fmax(cost[k - 1].error[of] + slope * log(step / cost[k - 1].step), 0);
}

double timescale_excess(double step) { return error_of(step, EXCESS_OF); }
double timescale_early(double step) { return error_of(step, EARLY_OF); }

static double step_of(const struct run *r) {
    if (r->dt > 0 || !r->fluid) return r->dt;
    const double of_fluid = r->scene->stage[r->stage].cfl * fluid_limits_foreseen(r->fluid).step;
    return fmin(of_fluid, fmin(time_step_first(r), time_step_breaking(r)));
}

double timescale_substeps(struct run *r) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    if (!r->needs.bonds || stage->solid != SCENE_SOLID_ELASTIC || stage->relax) return 0;
    if (stage->substeps > 0) return stage->substeps;
    const double least = ceil(step_of(r) / (stage->safety * r->solid_stable) * (1 - 1e-12));
    return isfinite(least) ? fmax(fmax(least, r->substeps), 1) : 1;
}

int timescale_breaking(const struct run *r, double *step, double *excess, double *early, double *advised) {
    const double stable = solid_stable_of(&r->solid_rates, SOLID_VERLET, 0, NULL);
    if (!time_step_counts(r) || !isfinite(stable)) return 0;
    *step = step_of(r);
    *excess = timescale_excess(*step / stable);
    *early = timescale_early(*step / stable);
    double low = 0.1, high = cost[1].step;
    for (int k = 0; k < 40; k++) *(timescale_excess(sqrt(low * high)) < ADVISED ? &low : &high) = sqrt(low * high);
    *advised = low * stable;
    return 1;
}

static int breaks_too_much(const struct run *r, char sentence[TIMESCALE_SENTENCE]) {
    double step, excess, early, advised;
    if (!timescale_breaking(r, &step, &excess, &early, &advised) || excess < EXCESS) return 0;
    snprintf(
        sentence, TIMESCALE_SENTENCE,
        "stage %s: bonds may break, and the step of %.3g s is %.3g times the solid's stable step: about %.0f %% too "
        "many bonds will break, the first per cent of them after a time that is %.0f %% too short; time_step: %.2g for "
        "%g %% (docs/choosing.md)",
        r->scene->stage[r->stage].name, step, step / solid_stable_of(&r->solid_rates, SOLID_VERLET, 0, NULL), excess,
        early, advised, ADVISED);
    return 1;
}

int timescale_of(struct run *r, char sentence[TIMESCALE_SENTENCE]) {
    const double n = timescale_substeps(r), dt = step_of(r);
    if (!(n > 0)) return 0;
    if (n < COSTLY) return breaks_too_much(r, sentence);
    double fastest = 0;
    const enum physics_model model = (enum physics_model)r->solid->in.model;
    for (int m = 0; m < r->scene->solid->materials; m++) {
        const struct scene_material *s = &r->scene->solid->material[m];
        fastest = fmax(fastest, physics_waves_of(model, s->youngs_modulus,
                                                 physics_dilatation_ratio(model, s->poisson_ratio), s->density)
                                    .longitudinal);
    }
    snprintf(sentence, TIMESCALE_SENTENCE,
             "stage %s: %.0f substeps a step%s: the step of %.3g s%s is %.3g times the solid's stable step of %.3g s, "
             "limited by %s (waves of %.4g m/s cross a spacing of %.3g m in %.3g s). A softer or denser material, a "
             "larger spacing or a shorter time_step bring the two nearer to each other",
             r->scene->stage[r->stage].name, n, n < HOPELESS ? "" : ": the run is hopeless", dt,
             r->fluid ? " of the fluid" : "", dt / r->solid_stable, r->solid_stable,
             solid_stable_bound_name[r->solid_bound], fastest, r->solid->in.spacing, r->solid->in.spacing / fastest);
    return 1;
}
