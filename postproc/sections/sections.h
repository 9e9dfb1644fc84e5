/* Sections of the report. Each adds its numbers, files and plots; a section adds nothing if the run lacks its data. */
#pragma once
#include "postproc/charts/charts.h"
#include "postproc/data/body.h"
#include "postproc/draw/colour.h"
#include "postproc/facts.h"
#include "postproc/options.h"

enum { POSTPROC_PICTURES = 48 };
struct postproc_output {
    const char *folder; /* RUNDIR/post */
    struct postproc_options options;
    double level; /* of the damage contour of a plate, 0: not determined yet */
    struct postproc_facts facts;
    struct postproc_charts charts;
    int pictures;
    struct {
        char name[64], title[160]; /* pictures/NAME.png */
    } picture[POSTPROC_PICTURES];
    int frames; /* of the film: film/NAME_0001.png ... */
    char film[64], film_title[160];
    int failed; /* errno of the first file that could not be written, 0 */
    char failed_path[256];
};

void postproc_sections_run(struct postproc_output *out, const struct postproc_history *h); /* scene and scales */
/* solution.csv and the field of errors of a scene that is solved at once. */
void postproc_sections_solution(struct postproc_output *out, const struct postproc_history *h);
void postproc_sections_element_free(struct postproc_output *out,
                                    const struct postproc_history *h); /* pictures of such a plate */
/* The points of a plate, or of a nonlocal problem in a plane, if they are not a lattice. */
void postproc_sections_arrangement(struct postproc_output *out, const struct postproc_history *h);
void postproc_sections_medium(struct postproc_output *out, const struct postproc_history *h); /* dp, porosity, k */
void postproc_sections_fracture(struct postproc_output *out,
                                const struct postproc_history *h); /* bonds, fragments, onset */
void postproc_sections_fragments(struct postproc_output *out, const struct postproc_history *h); /* detached ones */
void postproc_sections_events(struct postproc_output *out, const struct postproc_history *h);    /* of events.csv */
void postproc_sections_modes(struct postproc_output *out, const struct postproc_history *h);     /* of the damage */
void postproc_sections_wall(struct postproc_output *out, const struct postproc_history *h);      /* seconds by part */
void postproc_sections_pdf(struct postproc_output *out, const struct postproc_history *h);       /* strain and stress */
/* Hits and false alarms of strain and stresses. */
void postproc_sections_criteria(struct postproc_output *out, const struct postproc_history *h);
void postproc_sections_profile(struct postproc_output *out, const struct postproc_history *h); /* pressure along x */
void postproc_sections_flow(struct postproc_output *out, const struct postproc_history *h);    /* planes of the fluid */
/* Pictures and film in 3D: solid and flow. */
void postproc_sections_pictures(struct postproc_output *out, const struct postproc_history *h);
void postproc_sections_crack(struct postproc_output *out,
                             const struct postproc_history *h); /* tips, branches, contour of a plate */
/* The numbers of that section only; writes no file. */
void postproc_sections_crack_numbers(struct postproc_output *out, const struct postproc_history *h);
/* Arms of a plate's cracks, by crack_particles.csv, or else by the damage above a level in a field file. */
struct postproc_plate;
void postproc_sections_arms(struct postproc_output *out, const struct postproc_history *h,
                            const struct postproc_plate *last, double level);
/* The level of the damage contour: from the options, else from the first field file and the initial cracks, else
 * 0.41. */
double postproc_sections_crack_level(struct postproc_output *out, const struct postproc_history *h);
void postproc_sections_plate(struct postproc_output *out,
                             const struct postproc_history *h); /* pictures and film of a plate */

/* Fluid in cracks below the grid: record of the injection, pictures and film of the cracks. */
void postproc_sections_crack_fluid(struct postproc_output *out, const struct postproc_history *h);
/* The numbers of that section that need no field; writes no file. */
void postproc_sections_crack_fluid_numbers(struct postproc_output *out, const struct postproc_history *h);

/* "t/t0 = 1.5" or "t = 2e-06 s": a time after the start of the stage. */
void postproc_sections_when(const struct postproc_history *h, double t, char text[64]);
/* "12.5 µs", of a run that ends after 0.01 s or later "0.0125 s": a time of the run. Returns the text. */
const char *postproc_sections_seconds(const struct postproc_history *h, double t, char text[64]);
/* The colours for values between two limits: diverging, with limits made symmetric, if both signs are there to more
 * than a fifth; otherwise viridis. */
enum postproc_map postproc_sections_map(double limit[2]);
/* Adds a picture that has been written to the list: pictures/NAME.png. */
void postproc_sections_picture(struct postproc_output *out, const char *name, const char *title);

/* Notes that a file could not be written, with errno; only the first one is kept. */
void postproc_sections_fail(struct postproc_output *out, const char *path);
