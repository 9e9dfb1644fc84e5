/* Log lines to the screen and to run.log, and the progress bar. */
#include "base/files/log.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/log_terminal.h"
#include "base/files/plain_file.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { EARLIER = 4096 };
static char earlier[EARLIER]; /* lines of rank 0 before the log has begun: run.log gets them then */
static FILE *file;
static int silent;
static int columns; /* width of the terminal; 0: output is not a terminal */
static int bar_shown;
static char bar_stage[64];
static long bar_first;
static double bar_begun, bar_drawn;

void log_begin(const char *folder, int quiet, int resume) {
    char path[FOLDER_PATH] = "";
    int fault = 0;
    silent = quiet;
    columns = quiet || par_rank() != 0 ? 0 : log_terminal_columns();
    bar_stage[0] = '\0';
    if (folder && par_rank() == 0) {
        file = plain_file_write(folder_path(path, folder, "run.log"), resume);
        if (file)
            setvbuf(file, NULL, _IOLBF, BUFSIZ);
        else
            fault = errno;
        if (file) fputs(earlier, file);
        earlier[0] = '\0';
    }
    par_bcast(&fault, sizeof fault, 0);
    if (fault) die_all(EXIT_CODE_FILE, "%s/run.log: cannot be written: %s", folder, plain_file_why(fault));
}

static void bar_wipe(void) {
    if (bar_shown) fputs("\r\033[K", stdout);
    bar_shown = 0;
}

void log_end(void) {
    if (par_rank() != 0) return;
    if (bar_shown) fputc('\n', stdout);
    bar_shown = 0;
    fflush(stdout);
    if (file) fclose(file);
    file = NULL;
}

static void write_line(const char *line) {
    if (!silent) {
        bar_wipe();
        printf("%s\n", line);
        fflush(stdout);
    }
    if (file)
        fprintf(file, "%s\n", line);
    else
        snprintf(earlier + strlen(earlier), EARLIER - strlen(earlier), "%s\n", line);
}

void log_line(const char *format, ...) {
    char line[1024];
    va_list args;
    if (par_rank() != 0) return;
    clock_begin(CLOCK_LOG);
    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    write_line(line);
    clock_end(CLOCK_LOG);
}

/* "1:02:03" or "2:03". */
static void duration(char *text, size_t bytes, double seconds) {
    const long s = (long)(seconds + 0.5);
    if (s >= 3600)
        snprintf(text, bytes, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
    else
        snprintf(text, bytes, "%ld:%02ld", s / 60, s % 60);
}

/* Draws [=====     ] as wide as the terminal allows beside the text. */
static void bar_draw(const char *stage, long step, long total, const char *text) {
    char bar[64];
    int wide = columns - (int)strlen(stage) - (int)strlen(text) - 6;
    if (wide > (int)sizeof bar - 1) wide = (int)sizeof bar - 1;
    if (wide < 0) wide = 0;
    const int full = total > 0 ? (int)((double)wide * (double)step / (double)total) : 0;
    for (int k = 0; k < wide; k++) bar[k] = k < full ? '=' : ' ';
    bar[wide] = '\0';
    printf("\r\033[K%s [%s] %.*s", stage, bar, columns > 4 ? columns - 4 : 0, text);
    fflush(stdout);
    bar_shown = 1;
}

void log_progress(const char *stage, long step, long total, long every, const char *format, ...) {
    if (par_rank() != 0) return;
    const double now = par_seconds();
    if (strncmp(bar_stage, stage, sizeof bar_stage - 1) != 0 || step < bar_first) {
        snprintf(bar_stage, sizeof bar_stage, "%s", stage);
        bar_first = step - 1;
        bar_begun = bar_drawn = 0;
    }
    if (bar_begun == 0) { /* the first step's own duration is not known: the rate counts from its end */
        bar_begun = now;
        bar_first = step;
    }
    const int line = step == total || (every > 0 && step % every == 0);
    const int draw = columns > 0 && (now - bar_drawn > 0.1 || step == total);
    if (!line && !draw) return;

    char own[256], text[512], left[32] = "?";
    va_list args;
    va_start(args, format);
    vsnprintf(own, sizeof own, format, args);
    va_end(args);
    const double seconds = now - bar_begun, rate = seconds > 0 ? (double)(step - bar_first) / seconds : 0;
    if (rate > 0) duration(left, sizeof left, (double)(total - step) / rate);
    snprintf(text, sizeof text, "%ld/%ld  %.3g steps/s  %s left  %s", step, total, rate, left, own);
    if (draw) {
        bar_draw(stage, step, total, text);
        bar_drawn = now;
        if (step == total) bar_wipe();
    }
    if (!line) return;
    if (!silent && (columns == 0 || step == total)) {
        printf("%s  %s\n", stage, text);
        fflush(stdout);
    }
    if (file) fprintf(file, "%s  %s\n", stage, text);
}
