/* Width of the terminal, also when the program is started by mpiexec. */
#include "base/files/log_terminal.h"

#include <fcntl.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

static int columns_of(int fd) {
    struct winsize window = {0};
    return ioctl(fd, TIOCGWINSZ, &window) == 0 ? window.ws_col : 0;
}

/* Open MPI's mpiexec gives each rank a pseudo-terminal of size 0. Then the terminal of mpiexec itself is asked, if it
 * has one. */
static int launcher_columns(void) {
    char path[64];
    struct stat is;
    snprintf(path, sizeof path, "/proc/%ld/fd/1", (long)getppid());
    if (stat(path, &is) != 0 || !S_ISCHR(is.st_mode)) return 0;
    const int fd = open(path, O_WRONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    const int columns = fd >= 0 && isatty(fd) ? columns_of(fd) : 0;
    if (fd >= 0) close(fd);
    return columns;
}

int log_terminal_columns(void) {
    if (!isatty(STDOUT_FILENO)) return 0;
    const int columns = columns_of(STDOUT_FILENO);
    return columns > 0 ? columns : launcher_columns();
}
