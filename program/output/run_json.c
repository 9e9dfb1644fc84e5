/* Writes run.json: version, machine, run times by part, traffic, and what was left out. */
#include "program/output/run_json.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/threads.h"
#include "base/par_count.h"
#include "base/files/folder.h"
#include "base/files/json.h"
#include "coupling/control/time_step.h"
#include "program/output/build_info.h"
#include "program/output/left_out.h"
#include "scene/text/yaml.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void write_parts(struct json *j, const struct timeline *t) {
    json_object(j, "wall_seconds_by_part");
    for (int p = 0; p < CLOCK_PARTS; p++) json_number(j, clock_name((enum clock_part)p), timeline_seconds(t, p));
    json_close(j);
}

/* Writes the traffic per step of the rank that sends most, by kind; set-up and output included. */
static void write_traffic(struct json *j, double (*most)[3], long steps) {
    json_object(j, "traffic_per_step");
    for (int k = 0; k < PAR_COUNT_KINDS; k++) {
        json_object(j, par_count_name((enum par_count_kind)k));
        json_number(j, "messages", most[k][0] / (double)steps);
        json_number(j, "collectives", most[k][1] / (double)steps);
        json_number(j, "bytes", most[k][2] / (double)steps);
        json_close(j);
    }
    json_close(j);
}

/* Writes what limited the automatic steps and substeps. */
static void write_bounds(struct json *j, const struct step_control *a) {
    json_object(j, "steps_bound_by");
    for (int k = STEP_BOUND_CONVECTION; k < STEP_BOUNDS; k++)
        if (a->bound_steps[k]) json_long(j, time_step_bound_name[k], a->bound_steps[k]);
    json_close(j);
    json_object(j, "substeps_bound_by");
    for (int k = 0; k < STEP_SOLID_BOUNDS; k++)
        if (a->substep_bound_steps[k]) json_long(j, solid_stable_bound_name[k], a->substep_bound_steps[k]);
    json_close(j);
    json_long(j, "steps_made_again", a->repeated);
}

static double member(const struct scene_node *root, const char *key) {
    const struct scene_node *node = scene_node_child(root, key);
    char *end;
    const double value = node && node->value ? strtod(node->value, &end) : NAN;
    return node && node->value && *end == '\0' ? value : NAN;
}

double run_json_earlier_seconds(const char *folder, long step) {
    double seconds = NAN;
    if (par_rank() == 0) {
        char path[FOLDER_PATH];
        struct scene_node *root = scene_yaml_read(folder_path(path, folder, "run.json"));
        if (root && member(root, "steps") == (double)step) {
            seconds = member(root, "wall_seconds") - member(root, "setup_seconds");
            if (scene_node_child(root, "wall_seconds_earlier")) seconds += member(root, "wall_seconds_earlier");
        }
        if (root) scene_node_free(root);
    }
    par_bcast(&seconds, sizeof seconds, 0);
    return seconds;
}

void run_json_write(struct run *r, struct timeline *t, const char *folder, const char *status, int exit_code) {
    const int size = par_size();
    const long directed = run_directed_bonds(r);
    double local[1 + MEMORY_PARTS];
    timeline_collect(t, r->step);
    double traffic[PAR_COUNT_KINDS][3];
    for (int k = 0; k < PAR_COUNT_KINDS; k++) {
        const struct par_count sent = par_count_of((enum par_count_kind)k);
        traffic[k][0] = (double)sent.messages;
        traffic[k][1] = (double)sent.collectives;
        traffic[k][2] = (double)sent.bytes;
    }
    par_max_array(&traffic[0][0], 3 * PAR_COUNT_KINDS);
    local[0] = (double)memory_peak();
    for (int p = 0; p < MEMORY_PARTS; p++) local[1 + p] = (double)memory_bytes((enum memory_part)p);
    double *memory = malloc((size_t)size * sizeof local);
    par_gather(local, sizeof local, memory);
    if (par_rank() == 0) {
        char path[FOLDER_PATH], sentence[LEFT_OUT_MAX][LEFT_OUT_SENTENCE];
        struct json *j = json_begin(folder_path(path, folder, "run.json"));
        json_text(j, "title", r->scene->title);
        json_text(j, "status", status);
        json_long(j, "exit_code", exit_code);
        json_text(j, "stage", r->scene->stage[r->stage].name);
        json_long(j, "stage_step", r->stage_step);
        json_number(j, "stage_began", r->began[r->stage]);
        json_long(j, "steps", r->step);
        json_long(j, "resumed_at_step", r->resumed); /* times and counts below are from that step on */
        json_number(j, "t", r->t);
        json_number(j, "dt", r->dt);
        json_long(j, "substeps", r->substeps);
        if (r->scene->stage[r->stage].has_until) json_bool(j, "steady", steady_has_ended(r));
        write_bounds(j, &r->control);
        json_long(j, "ranks", size);
        json_long(j, "threads", threads_count());
        json_number(j, "wall_seconds", timeline_wall(t));
        json_number(j, "setup_seconds", r->setup_seconds); /* part of it, before the first step */
        if (r->wall_earlier != 0) json_number(j, "wall_seconds_earlier", r->wall_earlier);
        if (!strcmp(status, "done"))
            json_number(j, "end_seconds", timeline_last(t)); /* part of it, after the last step */
        write_parts(j, t);
        const double fluid =
            timeline_seconds(t, CLOCK_MOMENTUM) + timeline_seconds(t, CLOCK_POISSON) + timeline_seconds(t, CLOCK_HALO);
        if (r->fluid) json_long(j, "cells", (long)fluid_cells(r->fluid));
        if (r->solid) json_long(j, "particles", r->solid->n_global);
        if (r->needs.bonds) json_long(j, "directed_bonds", directed);
        if (r->fluid_cell_steps) json_number(j, "ns_per_cell_step", 1e9 * fluid * size / (double)r->fluid_cell_steps);
        if (r->solid_sweeps && directed)
            json_number(j, "ns_per_directed_bond_sweep",
                        1e9 * timeline_seconds(t, CLOCK_SOLID) * size / ((double)r->solid_sweeps * (double)directed));
        json_array(j, "peak_memory_bytes_per_rank");
        for (int k = 0; k < size; k++) json_number(j, NULL, memory[k * (1 + MEMORY_PARTS)]);
        json_close(j);
        if (r->step > r->resumed) write_traffic(j, traffic, r->step - r->resumed);
        json_object(j, "memory_bytes_by_part");
        for (int p = 0; p < MEMORY_PARTS; p++) {
            double sum = 0;
            for (int k = 0; k < size; k++) sum += memory[k * (1 + MEMORY_PARTS) + 1 + p];
            json_number(j, memory_name((enum memory_part)p), sum);
        }
        json_close(j);
        timeline_write(t, j);
        json_array(j, "left_out");
        for (int k = 0, n = left_out_of(r->scene, sentence); k < n; k++) json_text(j, NULL, sentence[k]);
        json_close(j);
        build_info_write(j);
        json_end(j);
    }
    free(memory);
}
