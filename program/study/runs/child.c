/* Runs another program and waits for it or for a signal. */
#include "program/study/runs/child.h"
#include "base/die.h"
#include "base/unfinished.h"
#include "base/files/plain_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stddef.h>
#include <stdio.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

static int stopped;

static sigset_t waited_for(int with_child) {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    sigaddset(&set, SIGHUP);
    sigaddset(&set, SIGUSR1);
    if (with_child) sigaddset(&set, SIGCHLD);
    return set;
}

static void end(int number) {
    static const char sentence[] =
        "frana: study: stopped while it was writing: nothing is kept of what is not finished\n";
    (void)number;
    unfinished_remove();
    if (write(STDERR_FILENO, sentence, sizeof sentence - 1) < 0) _exit(EXIT_CODE_FILE);
    _exit(EXIT_CODE_REQUEUE);
}

void study_child_note(int on) {
    static const int ends[] = {SIGINT, SIGTERM, SIGHUP, SIGUSR1};
    const sigset_t set = waited_for(1);
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++)
        if (signal(ends[k], on ? SIG_DFL : end) == SIG_IGN) signal(ends[k], SIG_IGN); /* as nohup wants it */
    sigprocmask(on ? SIG_BLOCK : SIG_UNBLOCK, &set, NULL);
}

void study_child_begin(void) {
    study_child_note(1);
    stopped = 0;
}

int study_child_stopped(void) {
    const sigset_t set = waited_for(0);
    const struct timespec none = {0};
    const int signal = sigtimedwait(&set, NULL, &none);
    if (signal > 0) stopped = signal;
    return stopped;
}

/* Dies where there is a link, through which nothing is written, or a pipe, for which one would wait. */
static FILE *must_write(const char *path, int append) {
    FILE *file = plain_file_write(path, append);
    if (!file) die_all(EXIT_CODE_FILE, "%s: cannot be written: %s", path, plain_file_why(errno));
    return file;
}

/* Starts the program in a process group of its own, so that a terminal's ^C reaches only this program; no signal is
 * blocked in it. */
static int start(const struct study_child *c, pid_t *pid) {
    const sigset_t ours = waited_for(1);
    sigset_t none;
    posix_spawnattr_t how;
    posix_spawn_file_actions_t files;
    sigemptyset(&none);
    posix_spawnattr_init(&how);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&how, 0);
    posix_spawnattr_setsigmask(&how, &none);
    posix_spawnattr_setsigdefault(&how, &ours);
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    FILE *output = must_write(c->output, 0), *errors = must_write(c->errors, 1);
    posix_spawn_file_actions_adddup2(&files, fileno(output), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, fileno(errors), STDERR_FILENO);
    if (c->folder) posix_spawn_file_actions_addchdir_np(&files, c->folder);
    const int fault = posix_spawnp(pid, c->argv[0], &files, &how, c->argv, environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&how);
    fclose(output);
    fclose(errors);
    return fault;
}

int study_child_run(const struct study_child *c) {
    const sigset_t set = waited_for(1);
    pid_t pid;
    int status;
    if ((errno = start(c, &pid))) return 127;
    for (int killed = 0;;) {
        const pid_t ended = waitpid(pid, &status, WNOHANG);
        if (ended == pid || (ended < 0 && errno != EINTR)) break;
        const int signal = sigwaitinfo(&set, NULL);
        if (signal <= 0 || signal == SIGCHLD) continue;
        stopped = signal;
        if (signal == SIGUSR1) /* to the launcher alone, which hands it on to its ranks */
            kill(pid, SIGUSR1);
        else
            kill(-pid, killed++ ? SIGKILL : SIGTERM);
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}
