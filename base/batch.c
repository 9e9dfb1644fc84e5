/* Asks the batch system when this job ends, without waiting for the answer. */
#include "base/batch.h"

#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

enum { ANSWER = 65536 };           /* bytes that are read of an answer; qstat prints the whole environment */
static const double PATIENCE = 60; /* s after which a command that has not answered is ended */

static int was_asked;
static double end;    /* s since 1970, 0: not known */
static pid_t pid;     /* of the command, 0: none */
static int from = -1; /* its output */
static int is_pbs;
static double asked; /* s since 1970 */
static char *answer;
static size_t bytes;

static double since_1970(void) {
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double batch_duration(const char *text) {
    static const double unit[] = {1, 60, 3600, 86400}; /* s, of the fields from the last */
    double field[4], total = 0;
    int n = 0;
    for (text += strspn(text, " \t"); n < 4; text++) {
        char *after;
        if (*text < '0' || *text > '9') return -1;
        field[n++] = (double)strtol(text, &after, 10);
        text = after;
        if (*text != ':' && *text != '-') break;
    }
    if (*text && !strchr(" \t\r\n", *text)) return -1;
    for (int k = 0; k < n; k++) total += field[k] * unit[n - 1 - k];
    return total;
}

/* The text behind "key = " in a line of qstat; NULL: no such line. */
static const char *value_of(const char *text, const char *key) {
    const size_t n = strlen(key);
    for (const char *line = text; line; line = strchr(line, '\n')) {
        line += strspn(line, " \t\r\n");
        if (!strncmp(line, key, n) && !strncmp(line + n, " = ", 3)) return line + n + 3;
    }
    return NULL;
}

static double duration_of(const char *text, const char *key) {
    const char *value = value_of(text, key);
    return value ? batch_duration(value) : -1;
}

/* A local time as ctime prints it, "Wed Aug 11 17:13:12 2021", in seconds since 1970; -1: none. */
static double time_of(const char *text, const char *key) {
    struct tm local = {.tm_isdst = -1};
    const char *value = value_of(text, key);
    if (!value || !strptime(value, "%a %b %d %H:%M:%S %Y", &local)) return -1;
    return (double)mktime(&local);
}

/* The start is `stime` in OpenPBS and PBS Pro, `start_time` in Torque; Walltime.Remaining is Torque's. */
double batch_end_of_pbs(const char *text, double now) {
    const double wall = duration_of(text, "Resource_List.walltime"),
                 used = duration_of(text, "resources_used.walltime"), left = duration_of(text, "Walltime.Remaining"),
                 start = fmax(time_of(text, "stime"), time_of(text, "start_time"));
    if (wall >= 0 && start >= 0) return start + wall;
    if (left >= 0) return now + left;
    return wall >= 0 && used >= 0 ? now + fmax(wall - used, 0) : 0;
}

/* Starts the command with its output in a pipe. Nothing happens if there is no such command. */
static void start(char *const *argv) {
    int ends[2];
    sigset_t none, ignored;
    posix_spawnattr_t how;
    posix_spawn_file_actions_t files;
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    sigemptyset(&none);
    sigemptyset(&ignored);
    sigaddset(&ignored, SIGPIPE);
    sigaddset(&ignored, SIGXFSZ);
    posix_spawnattr_init(&how);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&how, 0);
    posix_spawnattr_setsigmask(&how, &none);
    posix_spawnattr_setsigdefault(&how, &ignored);
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    if (posix_spawnp(&pid, argv[0], &files, &how, argv, environ) == 0) {
        from = ends[0];
        fcntl(from, F_SETFL, O_NONBLOCK);
        answer = calloc(1, ANSWER);
        bytes = 0;
    } else {
        pid = 0;
        close(ends[0]);
    }
    close(ends[1]);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&how);
}

void batch_query(void) {
    char *slurm = getenv("SLURM_JOB_ID"), *pbs = getenv("PBS_JOBID");
    const char *known = getenv("SLURM_JOB_END_TIME");
    if (was_asked) return;
    was_asked = 1;
    if (known && strtod(known, NULL) > 0) {
        end = strtod(known, NULL);
        return;
    }
    asked = since_1970();
    is_pbs = !slurm && pbs;
    if (slurm) start((char *[]){"squeue", "-h", "-j", slurm, "-o", "%L", NULL});
    if (is_pbs) start((char *[]){"qstat", "-f", pbs, NULL});
}

static void stop_reading(void) {
    close(from);
    from = -1;
    free(answer);
    answer = NULL;
}

/* Reads what the command has printed; 1 at its end. */
static int read_on(void) {
    char rest[4096];
    for (;;) {
        const size_t capacity = ANSWER - 1 - bytes;
        const ssize_t n = read(from, capacity ? answer + bytes : rest, capacity ? capacity : sizeof rest);
        if (n <= 0) return n == 0;
        if (capacity) bytes += (size_t)n;
    }
}

double batch_end(void) {
    if (from >= 0 && read_on()) {
        const double left = is_pbs ? -1 : batch_duration(answer);
        end = is_pbs ? batch_end_of_pbs(answer, asked) : left >= 0 ? asked + left : 0;
        stop_reading();
    }
    if (pid > 0 && since_1970() - asked > PATIENCE) kill(pid, SIGKILL);
    if (pid > 0 && waitpid(pid, NULL, WNOHANG) != 0) pid = 0;
    return end;
}

void batch_reset(void) {
    if (pid > 0) kill(pid, SIGKILL);
    if (pid > 0) waitpid(pid, NULL, 0);
    if (from >= 0) stop_reading();
    pid = 0;
    end = 0;
    was_asked = 0;
}
