/* Keeps the names of files that are being written, so that a signal that ends the program leaves none of them behind.
 */
#include "base/unfinished.h"

#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST = 16, PATH = 1032 };
static char path_of[MOST][PATH]; /* "": a free place. The first character is written last, and is deleted first */
static volatile pid_t program;

void unfinished_add(const char *path) {
    const size_t n = strlen(path);
    if (n == 0 || n >= PATH) return;
    unfinished_drop(path);
    for (int k = 0; k < MOST; k++) {
        if (path_of[k][0]) continue;
        memcpy(path_of[k] + 1, path + 1, n);
        ((volatile char *)path_of[k])[0] = path[0];
        return;
    }
}

void unfinished_drop(const char *path) {
    for (int k = 0; k < MOST; k++)
        if (!strcmp(path_of[k], path)) ((volatile char *)path_of[k])[0] = '\0';
}

void unfinished_program(pid_t pid) { program = pid; }

void unfinished_remove(void) {
    if (program > 0 && kill(program, SIGKILL) == 0) waitpid(program, NULL, 0);
    for (int k = 0; k < MOST; k++)
        if (path_of[k][0]) unlink(path_of[k]);
}
