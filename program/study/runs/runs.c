/* Starts the missing runs of a study one after another, or one of them, and measures their quantities. */
#include "program/study/runs/runs.h"
#include "base/die.h"
#include "base/arena.h"
#include "base/files/folder.h"
#include "program/study/runs/child.h"
#include "program/study/runs/quantity.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Splits the launcher's command into words and replaces {ranks}. Returns the number of words, each a text. */
static int launcher_words(const char *launcher, int ranks, char **word) {
    int n = 0;
    for (const char *at = launcher + strspn(launcher, " "); *at; at += strspn(at, " ")) {
        const int length = (int)strcspn(at, " ");
        char *plain = arena_text("%.*s", length, at), *mark = strstr(plain, "{ranks}");
        word[n++] = mark ? arena_text("%.*s%d%s", (int)(mark - plain), plain, ranks, mark + strlen("{ranks}"))
                         : arena_text("%s", plain);
        at += length;
    }
    return n;
}

/* [launcher] program run SCENE --out FOLDER --quiet --resume-or-start --set ...; NULL at the end. */
static char **words_of(const struct study_plan *p, const struct study_run *run, const char *program) {
    const struct study_case *c = &p->at[run->at];
    const struct study *s = p->study;
    char **word = arena_new(strlen(s->launcher) + 2 * (size_t)c->sets.n + 11, sizeof *word);
    int n = c->ranks > 1 ? launcher_words(s->launcher, c->ranks, word) : 0;
    const char *const plain[] = {program, "run", s->scene, "--quiet", "--resume-or-start", "--out", run->folder};
    for (size_t k = 0; k < sizeof plain / sizeof *plain; k++) word[n++] = arena_text("%s", plain[k]);
    for (int i = 0; i < c->sets.n; i++) {
        word[n++] = arena_text("--set");
        word[n++] = c->sets.text[i];
    }
    if (run->member) {
        word[n++] = arena_text("--set");
        word[n++] = run->member;
    }
    return word;
}

/* Starts the run, or goes on with it where it was stopped. Dies with exit code 4 if it is at work. */
static void start(const struct study_plan *p, struct study_run *run, const char *program, int fresh) {
    char output[FOLDER_PATH];
    char **word = words_of(p, run, program);
    folder_make(run->folder);
    folder_hold(run->folder);
    if (fresh || !study_plan_goes_on(p, run)) folder_clear(run->folder);
    folder_hold_release();
    folder_path(output, run->folder, "screen.log");
    const int code = study_child_run(&(struct study_child){word, NULL, output, output});
    if (code == 127)
        die_all(EXIT_CODE_FILE, "%s cannot be started%s%s", word[0], errno ? ": " : "", errno ? strerror(errno) : "");
    run->outcome = study_outcome_read(run->folder);
    if (code != 0 || run->outcome.state != STUDY_DONE) {
        run->outcome.state = STUDY_FAILED;
        run->outcome.exit_code = code;
    }
}

static void measure(const struct study_plan *p, struct study_run *run) {
    char *why;
    int wrong;
    for (int q = 0; q < p->study->quantities && !study_child_stopped(); q++) {
        const struct study_quantity *quantity = &p->study->quantity[q];
        run->value[q] = study_quantity_value(quantity, run->folder, &why, &wrong);
        if (wrong) die_all(EXIT_CODE_SCENE, "%s:%d: %s", p->study->path, quantity->line, why);
        if (!isfinite(run->value[q]) && !study_child_stopped()) fprintf(stderr, "frana: %s\n", why);
    }
}

/* Prints "about 3 min left". */
static void print_time_left(const struct study_plan *p, int next) {
    const double left = study_plan_left(p, next);
    if (isnan(left) || left == 0)
        printf("\n");
    else if (left < 100)
        printf("; about %.0f s left\n", left);
    else if (left < 5400)
        printf("; about %.0f min left\n", left / 60);
    else
        printf("; about %.1f h left\n", left / 3600);
}

static void print_run(const struct study_plan *p, int i) {
    const struct study_run *run = &p->run[i];
    const struct study_case *c = &p->at[run->at];
    const struct study_outcome *o = &run->outcome;
    printf("[%d/%d] %s, %s, ", i + 1, p->runs, p->study->methods.variant[c->method].name,
           p->study->levels.variant[c->level].name);
    if (run->member)
        printf("%s: ", run->member);
    else
        printf("repeat %d: ", run->repeat + 1);
    if (o->state == STUDY_SKIPPED)
        printf("left out, as an earlier repeat has failed");
    else if (o->state == STUDY_FAILED)
        printf("failed with exit code %d%s", o->exit_code, run->reused ? ", kept" : "");
    else
        printf("%.3g s%s", o->wall, run->reused ? ", kept" : "");
    if (o->state == STUDY_DONE)
        for (int q = 0; q < p->study->quantities && q < 3; q++)
            printf(", %s %.6g", p->study->quantity[q].name, run->value[q]);
    print_time_left(p, i + 1);
    fflush(stdout);
}

/* Whether a repeat of the same case has failed before. The members of an ensemble fail each for itself. */
static int has_failed(const struct study_plan *p, int i) {
    if (p->study->members.n > 0) return 0;
    for (int j = p->run[i].at; j < i; j += p->cases)
        if (p->run[j].outcome.state == STUDY_FAILED) return 1;
    return 0;
}

/* Makes run i unless it is used again or left out, measures it, and says so. Returns 1 if it was stopped. */
static int make(struct study_plan *p, const char *program, int fresh, int i) {
    struct study_run *run = &p->run[i];
    if (has_failed(p, i)) {
        run->outcome.state = STUDY_SKIPPED;
        print_run(p, i);
        return 0;
    }
    if (!run->reused && !study_child_stopped()) start(p, run, program, fresh);
    if (!study_child_stopped() && run->outcome.state == STUDY_DONE) measure(p, run);
    if (study_child_stopped() || (run->outcome.state == STUDY_FAILED && run->outcome.exit_code == EXIT_CODE_REQUEUE)) {
        printf("stopped at run %d of %d: the same command goes on from there\n", i + 1, p->runs);
        return 1;
    }
    print_run(p, i);
    return 0;
}

/* Looks which runs are there. Returns how many. */
static int scan(struct study_plan *p) {
    int made = 0;
    for (int i = 0; i < p->runs; i++) {
        study_plan_read(p, &p->run[i]);
        made += p->run[i].reused;
    }
    return made;
}

int study_runs_make(struct study_plan *p, const char *program, int fresh) {
    const int made = fresh ? 0 : scan(p);
    printf("%s: %d runs, %d of them made before\n", p->study->title, p->runs, made);
    for (int i = 0; i < p->runs; i++)
        if (make(p, program, fresh, i)) return EXIT_CODE_REQUEUE;
    return EXIT_CODE_DONE;
}

int study_runs_make_one(struct study_plan *p, const char *program, int fresh, int i) {
    struct study_run *run = &p->run[i];
    for (int j = run->at; j <= i && !fresh; j += p->cases) study_plan_read(p, &p->run[j]);
    if (make(p, program, fresh, i)) return EXIT_CODE_REQUEUE;
    return run->outcome.state == STUDY_FAILED ? run->outcome.exit_code : EXIT_CODE_DONE;
}

int study_runs_collect(struct study_plan *p) {
    printf("%s: %d runs, %d of them made\n", p->study->title, p->runs, scan(p));
    int missing = 0;
    for (int i = 0; i < p->runs; i++) {
        struct study_run *run = &p->run[i];
        if (has_failed(p, i)) run->outcome.state = STUDY_SKIPPED;
        if (run->outcome.state == STUDY_DONE) measure(p, run);
        if (study_child_stopped()) return -1;
        if (run->outcome.state == STUDY_TODO)
            missing++;
        else
            print_run(p, i);
    }
    return missing;
}

void study_runs_list(struct study_plan *p) {
    scan(p);
    for (int i = 0; i < p->runs; i++) {
        const struct study_run *run = &p->run[i];
        const enum study_state state = run->outcome.state;
        printf("%d %s %d %s\n", i + 1,
               state == STUDY_DONE     ? "done"
               : state == STUDY_FAILED ? "failed"
                                       : "missing",
               p->at[run->at].ranks, run->folder);
    }
}

void study_runs_say_missing(const struct study_plan *p, FILE *to) {
    const char *between = "";
    for (int i = 0; i < p->runs; i++) {
        if (p->run[i].outcome.state != STUDY_TODO) continue;
        fprintf(to, "%s%d", between, i + 1);
        between = ",";
    }
    fputc('\n', to);
}
