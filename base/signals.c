/* Stops a run at a signal, at --max-wall or at the batch system's limit, on all ranks together. */
#include "base/signals.h"
#include "base/batch.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/unfinished.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static volatile sig_atomic_t caught;  /* the signal's number */
static volatile sig_atomic_t at_once; /* 1, 2: a reason ends the program where it is */
static double wall_deadline;          /* on par_seconds' clock, 0: none */
static double held_back;              /* s that writing a checkpoint takes */
static int begun;

static const double ENDING = 10; /* s before the batch system's limit: the program and its job script end after the
                                  * checkpoint */
static const double GRACE = 10;  /* s beyond --max-wall that a set-up and a step have to end by themselves */

static volatile sig_atomic_t speaks; /* rank 0 */

static const char ENDS[] = "\nends after this step, with a checkpoint; Ctrl-C again ends at once, without one\n";

static void write_text(const char *text) {
    if (speaks && write(STDERR_FILENO, text, strlen(text)) < 0) speaks = 0;
}

static const char *name_of(int number) {
    return number == SIGTERM   ? "SIGTERM"
           : number == SIGUSR1 ? "SIGUSR1"
           : number == SIGINT  ? "SIGINT"
           : number == SIGALRM ? "--max-wall"
                               : "a signal";
}

/* In the handler of a signal, where nothing else may be called. */
static _Noreturn void end_at_once(int number) {
    write_text("frana: stopped by ");
    write_text(name_of(number));
    write_text(at_once == 2   ? ": nothing is kept of what is not finished\n"
               : at_once == 3 ? " during the set-up of a run: no step is lost, the same command goes on\n"
                              : " during the set-up: no step is lost, --resume-or-start goes on\n");
    unfinished_remove();
    _exit(EXIT_CODE_REQUEUE);
}

static void catch (int number) {
    const int before = errno; /* of the call that is interrupted */
    if (at_once) end_at_once(number);
    if (number == SIGALRM) return;
    caught = number;
    if (number == SIGINT) write_text(ENDS);
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
    sigaction(SIGALRM, &action, NULL);
    action.sa_flags = SA_RESTART | SA_RESETHAND;
    sigaction(SIGINT, &action, NULL);
    signal(SIGXFSZ, SIG_IGN); /* a write beyond a file size limit or to a closed terminal returns an error instead */
    signal(SIGPIPE, SIG_IGN);
    caught = at_once = 0;
    begun = 1;
    held_back = 0;
    speaks = par_rank() == 0;
    wall_deadline = max_wall > 0 ? par_seconds() + max_wall : 0;
    if (par_rank() == 0) batch_query();
}

void signals_at_once(int on) {
    struct itimerval timer = {{0, 0}, {0, 0}};
    at_once = on;
    if (on && caught) end_at_once(caught);
    if (on && wall_deadline > 0) {
        const double left = fmax(wall_deadline + GRACE - par_seconds(), 1e-3);
        timer.it_value.tv_sec = (time_t)left;
        timer.it_value.tv_usec = (suseconds_t)(1e6 * (left - floor(left)));
    }
    setitimer(ITIMER_REAL, &timer, NULL);
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

/* A signal on any rank is reported before a time limit. One reduction finds all of it. grace: s beyond --max-wall. */
static enum signals_reason agree(double reserve, double grace, double *also, int n) {
    enum { REASONS = 3 };
    double has[REASONS + SIGNALS_ALSO];
    ENSURE(n <= SIGNALS_ALSO, "%d numbers along", n);
    has[0] = caught != 0;
    has[1] = wall_deadline > 0 && par_seconds() + reserve > wall_deadline + grace;
    has[2] = signals_batch_left() < reserve + ENDING;
    for (int k = 0; k < n; k++) has[REASONS + k] = also[k];
    par_max_array(has, REASONS + n);
    for (int k = 0; k < n; k++) also[k] = has[REASONS + k];
    if (has[0] > 0) return SIGNALS_SIGNAL;
    if (has[1] > 0) return SIGNALS_MAX_WALL;
    return has[2] > 0 ? SIGNALS_BATCH : SIGNALS_NONE;
}

enum signals_reason signals_stop(double reserve) { return agree(reserve, 0, NULL, 0); }

enum signals_reason signals_stop_also(double reserve, double *also, int n) { return agree(reserve, 0, also, n); }

void signals_hold_back(double seconds) { held_back = seconds; }

enum signals_reason signals_poll(struct signals_poll_state *poll) {
    enum { MOST = 1 << 10 };
    static const double PACE = 0.5; /* s */
    if (!begun || at_once || ++poll->turns < poll->every) return SIGNALS_NONE;
    double took = par_seconds() - poll->last;
    const int is_first = poll->every == 0;
    const enum signals_reason reason = is_first ? SIGNALS_NONE : agree(held_back, GRACE, &took, 1);
    if (is_first)
        poll->every = 1;
    else if (took < PACE && poll->every < MOST)
        poll->every *= 2;
    else if (took > 2 * PACE && poll->every > 1)
        poll->every /= 2;
    poll->turns = 0;
    poll->last = par_seconds();
    return reason;
}

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
    return name_of(caught);
}
