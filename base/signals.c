/* Stops a run at a signal, at --max-wall or at the batch system's limit, on all ranks together. */
#include "base/signals.h"
#include "base/batch.h"
#include "base/ensure.h"
#include "base/par.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static volatile sig_atomic_t caught; /* the signal's number */
static double wall_deadline;         /* on par_seconds' clock, 0: none */

static const double ENDING = 10; /* s before the batch system's limit: the program and its job script end after the
                                  * checkpoint */

static volatile sig_atomic_t speaks; /* rank 0 */

static const char ENDS[] = "\nends after this step, with a checkpoint; Ctrl-C again ends at once, without one\n";

static void catch (int number) {
    const int before = errno; /* of the call that is interrupted */
    caught = number;
    if (number == SIGINT && speaks && write(STDERR_FILENO, ENDS, sizeof ENDS - 1) < 0) speaks = 0;
    errno = before;
}

void signals_begin(double max_wall) {
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = catch;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGUSR1, &action, NULL);
    action.sa_flags = SA_RESTART | SA_RESETHAND;
    sigaction(SIGINT, &action, NULL);
    signal(SIGXFSZ, SIG_IGN); /* a write beyond a file size limit or to a closed terminal returns an error instead */
    signal(SIGPIPE, SIG_IGN);
    caught = 0;
    speaks = par_rank() == 0;
    wall_deadline = max_wall > 0 ? par_seconds() + max_wall : 0;
    if (par_rank() == 0) batch_ask();
}

static double since_1970(void) {
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double signals_batch_left(void) {
    const double end = par_rank() == 0 ? batch_end() : 0;
    return end > 0 ? end - since_1970() : INFINITY;
}

/* A signal on any rank is reported before a time limit. One reduction finds all of it. */
enum signals_reason signals_stop_also(double reserve, double *also, int n) {
    enum { REASONS = 3 };
    double has[REASONS + SIGNALS_ALSO];
    ENSURE(n <= SIGNALS_ALSO, "%d numbers along", n);
    has[0] = caught != 0;
    has[1] = wall_deadline > 0 && par_seconds() + reserve > wall_deadline;
    has[2] = signals_batch_left() < reserve + ENDING;
    for (int k = 0; k < n; k++) has[REASONS + k] = also[k];
    par_max_array(has, REASONS + n);
    for (int k = 0; k < n; k++) also[k] = has[REASONS + k];
    if (has[0] > 0) return SIGNALS_SIGNAL;
    if (has[1] > 0) return SIGNALS_MAX_WALL;
    return has[2] > 0 ? SIGNALS_BATCH : SIGNALS_NONE;
}

enum signals_reason signals_stop(double reserve) { return signals_stop_also(reserve, NULL, 0); }

const char *signals_name(enum signals_reason reason) {
    switch (reason) {
    case SIGNALS_NONE:
        return "no reason";
    case SIGNALS_MAX_WALL:
        return "--max-wall";
    case SIGNALS_BATCH:
        return "the batch system's limit";
    case SIGNALS_SIGNAL:
        break;
    }
    return caught == SIGTERM ? "SIGTERM" : caught == SIGUSR1 ? "SIGUSR1" : caught == SIGINT ? "SIGINT" : "a signal";
}
