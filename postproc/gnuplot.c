/* Calls gnuplot, and writes what all scripts share. */
#include "postproc/gnuplot.h"
#include "base/ensure.h"
#include "base/unfinished.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"

#include <errno.h>
#include <math.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* One gnuplot draws all pictures of a command. To start it and to find the typeface takes longer than to draw. It reads
 * its commands from a socket, whose other end is `link`, and answers there. */
static struct {
    pid_t pid;
    int link;
} session = {.link = -1};

/* Returns whether there is a gnuplot. */
static int begin(void) {
    int ends[2];
    if (session.link >= 0) return 1;
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends)) return 0;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    char program[] = "gnuplot", *argv[] = {program, NULL};
    const int fault = posix_spawnp(&session.pid, program, &actions, NULL, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (fault)
        close(ends[0]);
    else
        session.link = ends[0];
    unfinished_program(fault ? 0 : session.pid);
    return !fault;
}

void postproc_gnuplot_end(void) {
    if (session.link < 0) return;
    close(session.link);
    session.link = -1;
    unfinished_program(0);
    while (waitpid(session.pid, NULL, 0) < 0)
        if (errno != EINTR) return;
}

/* Returns whether gnuplot accepted all of the text. */
static int send_text(const char *text, size_t length) {
    while (length > 0) {
        const ssize_t n = send(session.link, text, length, MSG_NOSIGNAL);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return 0;
        text += n;
        length -= (size_t)n;
    }
    return 1;
}

/* The number that gnuplot prints on a line of its own: that of its last error, 0 if there was none. -1: gnuplot has
 * ended. */
static int read_status(void) {
    char line[32];
    for (size_t n = 0; n < sizeof line - 1;) {
        const ssize_t got = recv(session.link, line + n, 1, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return -1;
        if (line[n] != '\n') {
            n++;
            continue;
        }
        line[n] = '\0';
        return atoi(line);
    }
    return -1;
}

/* 'one'."\n".'two' for a path with a new line, which ends a command. */
static void put_path(FILE *f, const char *path) {
    for (const char *line = path;; line += strcspn(line, "\n") + 1) {
        char *part = strndup(line, strcspn(line, "\n"));
        postproc_gnuplot_text(f, part ? part : "");
        free(part);
        if (!strchr(line, '\n')) return;
        fputs(".\"\\n\".", f);
    }
}

/* Runs a script in the folder, without a shell and without output. */
static enum postproc_plot_status run(const char *folder, const char *script) {
    char *text = NULL, *whole = realpath(folder, NULL);
    size_t length = 0;
    if (!whole) return POSTPROC_PLOT_FAILED;
    if (!begin()) {
        free(whole);
        return POSTPROC_PLOT_NO_GNUPLOT;
    }
    FILE *f = open_memstream(&text, &length);
    fputs("set output\nreset session\nreset errors\nset print '-'\npart = '.part'\ncd ", f);
    put_path(f, whole);
    fputs("\nload ", f);
    postproc_gnuplot_text(f, script);
    fputs("\nset output\nprint GPVAL_ERRNO\n", f);
    fclose(f);
    const int fault = send_text(text, length) ? read_status() : -1;
    if (fault < 0) postproc_gnuplot_end();
    free(text);
    free(whole);
    return fault ? POSTPROC_PLOT_FAILED : POSTPROC_PLOT_DONE;
}

static const char *script_of(const char *name, char file[256]) {
    snprintf(file, 256, "%s.gp", name);
    return file;
}

FILE *postproc_gnuplot_script_new(const char *folder, const char *name) {
    char path[FOLDER_PATH], file[256];
    FILE *f = atomic_write_open(folder_path(path, folder, script_of(name, file)));
    if (f) fprintf(f, "# gnuplot %s\nif (!exists('part')) part = ''\n", file);
    return f;
}

static const char *const ending[POSTPROC_FORMATS] = {"png", "svg", "pdf"};

/* The name of a picture while gnuplot draws it. */
static const char *part_of(char part[FOLDER_PATH], const char *folder, const char *name, int format) {
    char file[256];
    snprintf(file, sizeof file, "%s.%s.part", name, ending[format]);
    return folder_path(part, folder, file);
}

/* Gives the pictures of a script their names; not every script draws all formats. Returns 0 or -1. */
static int publish(const char *folder, const char *name) {
    char path[FOLDER_PATH], part[FOLDER_PATH], file[256];
    for (int k = 0; k < POSTPROC_FORMATS; k++) {
        snprintf(file, sizeof file, "%s.%s", name, ending[k]);
        folder_path(path, folder, file);
        const int fault = atomic_write_publish(part_of(part, folder, name, k), path, 0);
        if (fault && fault != ENOENT) return -1;
    }
    return 0;
}

enum postproc_plot_status postproc_gnuplot_script_end(FILE *f, const char *folder, const char *name) {
    char path[FOLDER_PATH], part[FOLDER_PATH], file[256];
    fputs("set output\n", f);
    if (atomic_write_close(f, folder_path(path, folder, script_of(name, file)), 0)) return POSTPROC_PLOT_NO_FILE;
    for (int k = 0; k < POSTPROC_FORMATS; k++) {
        unfinished_add(part_of(part, folder, name, k));
        unlink(part); /* gnuplot would write through a link, and wait for a pipe */
    }
    enum postproc_plot_status status = run(folder, file);
    if (status == POSTPROC_PLOT_DONE && publish(folder, name)) status = POSTPROC_PLOT_FAILED;
    for (int k = 0; k < POSTPROC_FORMATS; k++) unfinished_drop(part_of(part, folder, name, k));
    return status;
}

enum { TITLE_LINE = 105 }; /* bytes of a title in the width of a plot */

static void put_title_line(FILE *f, int label, double height, const char *from, const char *end) {
    char *line = strndup(from, (size_t)(end - from));
    fprintf(f, "set label %d ", label);
    postproc_gnuplot_text(f, line ? line : "");
    fprintf(f, " at screen 0.03, screen %g left noenhanced font ',15' tc rgb '#23282e'\n", height);
    free(line);
}

/* The last words of a title that is too long stand in a second line. */
void postproc_gnuplot_title(FILE *f, const char *title) {
    const char *end = title + strlen(title), *gap = end - title > TITLE_LINE ? title + TITLE_LINE : end;
    while (gap < end && gap > title && *gap != ' ') gap--;
    if (gap == title) gap = end; /* a single word */
    put_title_line(f, 1, 0.955, title, gap);
    if (gap < end) put_title_line(f, 89, 0.922, gap + 1, end);
}

/* The typeface and the sizes of letters and lines are the same in all three: a point is 4/3 pixels of the PNG. Letters
 * of a PDF would be 4/3 larger without the scale, as measured with gnuplot 5.4. */
void postproc_gnuplot_terminal(FILE *f, enum postproc_format format, const char *name, int width, int height) {
    static const char style[] = "enhanced font 'DejaVu Sans,13' background '#ffffff'";
    switch (format) {
    case POSTPROC_PNG:
        fprintf(f, "set terminal pngcairo size %d,%d %s linewidth 1.4\n", width, height, style);
        break;
    case POSTPROC_SVG: /* its unit is the point */
        fprintf(f, "set terminal svg size %g,%g %s linewidth 1.05\n", 0.75 * width, 0.75 * height, style);
        break;
    case POSTPROC_PDF:
        fprintf(f, "set terminal pdfcairo size %.6gin,%.6gin %s fontscale 0.75 linewidth 2\n", width / 96.0,
                height / 96.0, style);
        break;
    case POSTPROC_FORMATS:
        ENSURE(0, "format %d", (int)format);
    }
    fprintf(f, "set output '%s.%s'.part\n", name, ending[format]);
}

void postproc_gnuplot_again(FILE *f, const char *name, int width, int height, const char *command) {
    for (int k = POSTPROC_PNG + 1; k < POSTPROC_FORMATS; k++) {
        postproc_gnuplot_terminal(f, (enum postproc_format)k, name, width, height);
        fprintf(f, "%s\n", command);
    }
}

void postproc_gnuplot_text(FILE *f, const char *text) {
    fputc('\'', f);
    for (; *text; text++) {
        if (*text == '\'') fputc('\'', f);
        fputc(*text == '\n' ? ' ' : *text, f);
    }
    fputc('\'', f);
}

int postproc_gnuplot_power(double most) {
    most = fabs(most);
    if (!(most > 0) || !isfinite(most) || (most >= 0.02 && most < 2e4)) return 0;
    return 3 * (int)floor(log10(most) / 3 + 1e-12);
}
