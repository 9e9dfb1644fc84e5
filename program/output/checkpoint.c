/* Writes a run's whole state to a checkpoint and reads it back on any number of ranks. */
#include "program/output/checkpoint.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/par.h"
#include "coupling/stage.h"
#include "coupling/transient.h"
#include "coupling/run_state.h"
#include "base/files/folder.h"
#include "base/files/state_file.h"
#include "base/files/table_rows.h"

#include <math.h>
#include <stdio.h>

static void write(struct run *r, const char *folder, const char *name, int keep) {
    struct run_state state;
    clock_begin(CLOCK_OUTPUT);
    struct store *s = store_begin(folder, name, keep);
    run_state_of(r, &state);
    state_file_write(s, &state.list);
    store_end(s);
    transient_reset(r);
    clock_end(CLOCK_OUTPUT);
}

void checkpoint_write(struct run *r, const char *folder) {
    char name[64];
    snprintf(name, sizeof name, "step_%08ld", r->step);
    write(r, folder, name, CHECKPOINTS_KEPT);
}

void checkpoint_write_stage(struct run *r, const char *folder) {
    char name[128];
    snprintf(name, sizeof name, "stage_%s", r->scene->stage[r->stage].name);
    write(r, folder, name, 0);
}

double checkpoint_bytes(struct run *r) {
    struct run_state state;
    run_state_of(r, &state);
    return state_file_bytes(&state.list);
}

/* Reads the whole checkpoint. Returns 0, or 1 with a sentence in why. */
static int read_state(struct run *r, struct store *s, char *why, size_t size) {
    struct run_state state;
    char fault[512];
    int head;
    run_state_of(r, &state);
    table_rows_set_expected(""); /* older checkpoints do not say it */
    const int bad = state_file_read(s, &state.list, &head, fault, sizeof fault);
    if (bad && fault[0])
        snprintf(why, size, "%s: %s", store_read_path(s), fault);
    else if (bad && (head || store_read_is_damaged(s)))
        snprintf(why, size, "%s", store_read_error());
    else if (bad)
        snprintf(why, size, "%s does not fit the scene: %s", store_read_path(s), store_read_error());
    return bad;
}

/* Says why a checkpoint cannot be resumed, and which one can. */
static _Noreturn void refuse(enum exit_code code, const char *path, const char *why) {
    const char *other = path && code == EXIT_CODE_FILE ? store_read_other(path) : NULL;
    if (other) die_all(code, "%s; --resume=%s is whole", why, other);
    die_all(code, "%s", why);
}

void checkpoint_require(const char *folder, const char *file) {
    struct store *s = file ? store_read_open(file) : NULL;
    if (file ? !s : !store_read_is_there(folder)) refuse(EXIT_CODE_FILE, file, store_read_error());
    store_read_close(s);
}

/* A solid whose particles are not where they began has moved. Collective. */
static void find_moved(struct run *r) {
    double most = 0;
    for (int c = 0; r->solid && c < r->solid->dim; c++)
        for (int h = 0; h < r->solid->n; h++) most = fmax(most, fabs(r->solid->d[c][h]));
    if (par_max(most) > 0) r->moved = r->step;
}

const char *checkpoint_read(struct run *r, const char *folder, const char *file) {
    struct store *s = file ? store_read_open(file) : store_read_open_latest(folder);
    if (!s) refuse(EXIT_CODE_FILE, file, store_read_error());
    static char path[FOLDER_PATH];
    char why[2048];
    snprintf(path, sizeof path, "%s", store_read_path(s));
    const int bad = read_state(r, s, why, sizeof why), damaged = store_read_is_damaged(s);
    store_read_close(s);
    if (bad) refuse(damaged ? EXIT_CODE_FILE : EXIT_CODE_CHECKPOINT, path, why);
    if (stage_has_ended(r) && r->stage + 1 < r->scene->stages) {
        r->stage++;
        r->stage_step = 0;
    }
    find_moved(r);
    transient_reset(r);
    return path;
}
