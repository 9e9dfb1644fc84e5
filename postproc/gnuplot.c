/* Calls gnuplot, and writes what all scripts share. */
#include "postproc/gnuplot.h"
#include "base/ensure.h"
#include "files/folder.h"

#include <errno.h>
#include <math.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

enum postproc_plot_status postproc_gnuplot_run(const char *folder, const char *script) {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", 0, 0);
    char program[] = "gnuplot", name[FOLDER_PATH];
    snprintf(name, sizeof name, "%s", script);
    char *argv[] = {program, name, NULL};
    pid_t pid;
    int status;
    const int fault = posix_spawnp(&pid, program, &actions, NULL, argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (fault) return POSTPROC_PLOT_NO_GNUPLOT;
    while (waitpid(pid, &status, 0) < 0)
        if (errno != EINTR) return POSTPROC_PLOT_FAILED;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? POSTPROC_PLOT_DONE : POSTPROC_PLOT_FAILED;
}

/* The typeface and the sizes of letters and lines are the same in all three: a point is 4/3 pixels of the PNG. Letters
 * of a PDF would be 4/3 larger without the scale, as measured with gnuplot 5.4. */
void postproc_gnuplot_terminal(FILE *f, enum postproc_format format, const char *name, int width, int height) {
    static const char look[] = "enhanced font 'DejaVu Sans,13' background '#ffffff'";
    switch (format) {
    case POSTPROC_PNG:
        fprintf(f, "set terminal pngcairo size %d,%d %s linewidth 1.4\nset output '%s.png'\n", width, height, look,
                name);
        return;
    case POSTPROC_SVG: /* its unit is the point */
        fprintf(f, "set terminal svg size %g,%g %s linewidth 1.05\nset output '%s.svg'\n", 0.75 * width, 0.75 * height,
                look, name);
        return;
    case POSTPROC_PDF:
        fprintf(f, "set terminal pdfcairo size %.6gin,%.6gin %s fontscale 0.75 linewidth 2\nset output '%s.pdf'\n",
                width / 96.0, height / 96.0, look, name);
        return;
    case POSTPROC_FORMATS:
        break;
    }
    ENSURE(0, "format %d", (int)format);
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
