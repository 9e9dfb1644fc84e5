/* Wall time by part of the program, with nested clocks. */
#include "base/clock.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/threads.h"

enum { DEPTH = 16 };

static double seconds[CLOCK_ALL];
static enum clock_part stack[DEPTH];
static int depth;
static double since;

void clock_begin(enum clock_part part) {
    if (threads_me() > 0) return; /* the first thread's time counts */
    const double now = par_seconds();
    ENSURE(depth < DEPTH, "clocks nest %d deep", depth);
    if (depth > 0) seconds[stack[depth - 1]] += now - since;
    stack[depth++] = part;
    since = now;
}

void clock_end(enum clock_part part) {
    if (threads_me() > 0) return;
    const double now = par_seconds();
    ENSURE(depth > 0 && stack[depth - 1] == part, "the %s clock ends out of order", clock_name(part));
    seconds[part] += now - since;
    depth--;
    since = now;
}

void clock_clear(void) {
    ENSURE(depth == 0, "the %s clock runs", clock_name(stack[depth - 1]));
    for (int p = 0; p < CLOCK_ALL; p++) seconds[p] = 0;
}

double clock_seconds(enum clock_part part) {
    double sum = seconds[part];
    for (int detail = CLOCK_PARTS; detail < CLOCK_ALL && part == CLOCK_POISSON; detail++) sum += seconds[detail];
    return sum;
}

const char *clock_name(enum clock_part part) {
    static const char *const name[CLOCK_ALL] = {"momentum", "poisson",   "halo",   "forcing", "probe",   "solid",
                                                "contact",  "interface", "output", "forward", "columns", "backward"};
    return name[part];
}
