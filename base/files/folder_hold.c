/* Locks the run folder so that only one run at a time writes there. */
/* Each rank of a run locks a byte of the file run.lock. The system releases a lock however a process ends, so a folder
 * is held until the last rank has ended, and no longer. On a file system without locks the file's text decides: it
 * names the host and the process of the run that holds the folder. */
#include "base/die.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/plain_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int file = -1;
static char held[FOLDER_PATH]; /* the lock file's path */
static pid_t owner;            /* the process that removes the file: rank 0, not a child process of it */

enum { HOST = 256, WORDS = HOST + FOLDER_PATH + 80 };

/* bytes 0: the whole file. Returns 0 or errno. */
static int lock(short type, off_t first, off_t bytes) {
    struct flock l = {.l_type = type, .l_whence = SEEK_SET, .l_start = first, .l_len = bytes};
    return fcntl(file, F_SETLK, &l) == 0 ? 0 : errno;
}

static int is_taken(int fault) { return fault == EACCES || fault == EAGAIN; }

static void release_lock(void) {
    close(file);
    file = -1;
}

/* Opens the file and locks all of it. Tries again if the run before has just removed the opened file. */
static int open_locked(const char *path) {
    for (;;) {
        struct stat opened, there;
        file = open(path, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
        if (file < 0) return errno;
        if (fstat(file, &opened) != 0 || !S_ISREG(opened.st_mode)) {
            release_lock();
            return ENODEV;
        }
        const int fault = lock(F_WRLCK, 0, 0);
        if (fault) return fault;
        if (stat(path, &there) == 0 && opened.st_ino == there.st_ino && opened.st_dev == there.st_dev) return 0;
        release_lock();
    }
}

static void read_holder(char words[WORDS], char host[HOST], long *process) {
    char text[HOST + 32];
    const ssize_t n = pread(file, text, sizeof text - 1, 0);
    text[n > 0 ? n : 0] = '\0';
    host[0] = words[0] = '\0';
    *process = 0;
    if (sscanf(text, "%255s %ld", host, process) == 2) snprintf(words, WORDS, " (process %ld on %s)", *process, host);
}

/* Whether the run that holds the folder still exists, on a file system without locks; a process on another host is
 * taken to be alive. */
static int is_alive(const char *host, long process) {
    char here[HOST] = "";
    gethostname(here, sizeof here - 1);
    if (process <= 0) return 0;
    return strcmp(here, host) != 0 || kill((pid_t)process, 0) == 0 || errno == EPERM;
}

/* Takes the folder, on rank 0. Returns 0, errno, or -1 with the holder in words. */
static int take(const char *path, char words[WORDS]) {
    char host[HOST] = "";
    long process;
    const int fault = open_locked(path);
    if (file < 0) return fault;
    read_holder(words, host, &process);
    const int alive = fault && !is_taken(fault) && is_alive(host, process);
    const size_t n = strlen(words);
    if (alive) snprintf(words + n, WORDS - n, "; should it be gone, delete %s", path);
    if (is_taken(fault) || alive) {
        release_lock();
        return -1;
    }
    gethostname(host, sizeof host - 1);
    lock(F_UNLCK, 1, 0); /* for the other ranks */
    if (ftruncate(file, 0) == 0) dprintf(file, "%s %ld\n", host, (long)getpid());
    return 0;
}

void folder_hold_release(void) {
    if (file < 0) return;
    if (owner == getpid()) unlink(held);
    release_lock();
}

void folder_hold(const char *folder) {
    struct {
        int fault;
        char words[WORDS];
    } answer = {0};
    char path[FOLDER_PATH];
    folder_path(path, folder, "run.lock");
    if (file >= 0 && !strcmp(path, held)) return;
    if (par_rank() == 0) answer.fault = take(path, answer.words);
    par_bcast(&answer, sizeof answer, 0);
    if (answer.fault == ENOENT) return;
    if (answer.fault < 0)
        die_all(EXIT_CODE_FILE, "run folder %s: another run is at work there%s", folder, answer.words);
    if (answer.fault)
        die_all(EXIT_CODE_FILE, "run folder %s: cannot be written: run.lock: %s", folder, plain_file_why(answer.fault));
    if (par_rank() != 0 && (file = open(path, O_RDWR | O_NOFOLLOW | O_CLOEXEC)) >= 0) lock(F_WRLCK, par_rank(), 1);
    snprintf(held, sizeof held, "%s", path);
    if (owner == 0 && par_rank() == 0) atexit(folder_hold_release);
    if (par_rank() == 0) owner = getpid();
    folder_clear_parts(folder);
}
