/* Decides whether a run starts, goes on or is done, by what its folder holds. */
#include "program/resume.h"
#include "base/die.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/store.h"
#include "program/made.h"

#include <stdio.h>

int resume_or_start(struct command *c, const struct scene *scene) {
    if (folder_is_foreign(c->out))
        die_all(EXIT_CODE_FILE, "%s holds other files and no run: give --out a folder of the run's own", c->out);
    folder_hold(c->out);
    const enum made made = made_in(c->out, scene);
    if (made == MADE_NOTHING) return 1;
    if (made == MADE_ALL) {
        if (par_rank() == 0) printf("%s: this run is done, nothing is left to do\n", c->out);
        folder_hold_release();
        return 0;
    }
    c->resume = store_read_is_there(c->out);
    if (made == MADE_OTHER && !c->resume)
        die_all(EXIT_CODE_FILE, "%s holds a run of another scene, without a checkpoint: --out DIR writes elsewhere",
                c->out);
    c->anew = !c->resume;
    return 1;
}
