/* Decides whether a run starts, goes on or is done, by what its folder holds. */
#include "program/run/resume.h"
#include "base/die.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/store.h"
#include "program/run/status.h"

#include <stdio.h>

int resume_or_start(struct command *c, const struct scene *scene) {
    if (folder_is_foreign(c->out))
        die_all(EXIT_CODE_FILE, "%s holds other files and no run: give --out a folder of the run's own", c->out);
    folder_hold(c->out);
    const enum run_status made = run_status_of(c->out, scene);
    if (made == RUN_STATUS_NONE) return 1;
    if (made == RUN_STATUS_DONE) {
        if (par_rank() == 0) printf("%s: this run is done, nothing is left to do\n", c->out);
        folder_hold_release();
        return 0;
    }
    c->resume = store_read_is_there(c->out);
    if (made == RUN_STATUS_OTHER_SCENE && !c->resume)
        die_all(EXIT_CODE_FILE, "%s holds a run of another scene, without a checkpoint: --out DIR writes elsewhere",
                c->out);
    c->archives = !c->resume;
    return 1;
}
