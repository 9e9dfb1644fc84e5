/* A child process that may end with a sentence. For tests of what the program refuses. */
#pragma once
#include "tests/check.h"

#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

/* What a child that reads a scene gets. */
struct leaves_scene {
    const char *path;
    int n;
    const char *const *set; /* [n] settings */
};

/* Calls child(with) in a process of its own, which then exits with 0. Returns its exit code, or -1 if a signal ended
 * it; said [size]: its standard error. */
static inline int leaves(void (*child)(void *), void *with, char *said, size_t size) {
    int pipes[2], status;
    assert_int_equal(pipe(pipes), 0);
    fflush(NULL);
    const pid_t pid = fork();
    if (pid == 0) {
        dup2(pipes[1], STDERR_FILENO);
        child(with);
        _exit(0);
    }
    close(pipes[1]);
    size_t got = 0;
    for (ssize_t k; got < size - 1 && (k = read(pipes[0], said + got, size - 1 - got)) > 0;) got += (size_t)k;
    said[got] = '\0';
    close(pipes[0]);
    waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
