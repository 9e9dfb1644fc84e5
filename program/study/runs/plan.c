/* Lists the runs of a study, with their scenes and folders, and finds those that exist already. */
#include "program/study/runs/plan.h"
#include "base/die.h"
#include "base/arena.h"
#include "base/sanitize.h"
#include "base/files/folder.h"
#include "base/files/store.h"
#include "base/files/read_file.h"
#include "scene/read.h"
#include "scene/scene.h"
#include "program/study/file/parts.h"
#include "program/study/text.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The resolved scene of a case; NULL if it has mistakes, which are reported. */
static char *resolve(const struct study *s, const struct study_case *c, char *member, const char *text) {
    struct scene_problems problems = {0};
    struct study_sets sets = {0};
    study_sets_join(&sets, &c->sets);
    if (member) study_sets_join(&sets, &(struct study_sets){1, &member});
    const struct study_variant *method = &s->methods.variant[c->method], *level = &s->levels.variant[c->level];
    struct scene *scene =
        scene_read(s->scene, text, strlen(text), sets.n, (const char *const *)sets.text, 1, &problems);
    for (int i = 0; i < problems.n; i++) {
        sanitize_text(problems.text[i]);
        fprintf(stderr, "frana: %s:%d: %s at level %s: %s\n", s->path, level->line, method->name, level->name,
                problems.text[i]);
    }
    scene_problem_free(&problems);
    char *resolved = scene ? arena_text("%s", scene->resolved) : NULL;
    scene_free(scene);
    return resolved;
}

/* Runs of a study write no fields unless its file or the scene says how many. */
static void fields_off(struct study_sets *sets, const char *scene) {
    const char *const no = "output.fields_every=0";
    int is_given = strstr(scene, "fields_every") != NULL;
    for (int i = 0; i < sets->n; i++) is_given |= strstr(sets->text[i], "fields_every") != NULL;
    char *text = (char *)(uintptr_t)no;
    if (!is_given) study_sets_join(sets, &(struct study_sets){1, &text});
}

static void case_begin(struct study_case *c, const struct study *s, int level, int method, const char *text) {
    const struct study_variant *m = &s->methods.variant[method], *l = &s->levels.variant[level];
    c->method = method;
    c->level = level;
    c->ranks = l->ranks ? l->ranks : m->ranks ? m->ranks : s->ranks;
    study_sets_join(&c->sets, &s->sets);
    study_sets_join(&c->sets, &m->sets);
    study_sets_join(&c->sets, &l->sets);
    fields_off(&c->sets, text);
    c->resolved = resolve(s, c, s->members.n > 0 ? s->members.text[0] : NULL, text);
    if (!c->resolved) exit(EXIT_CODE_SCENE);
}

/* Reports two names that would give the same folder. */
static void check_slugs(const struct study *s, const struct study_variants *v) {
    for (int i = 0; i < v->n; i++) {
        const char *its = study_text_slug(v->variant[i].name);
        for (int j = 0; j < i; j++)
            if (!strcmp(its, study_text_slug(v->variant[j].name)))
                die_all(EXIT_CODE_SCENE, "%s:%d: the names %s and %s differ only in signs that no folder has", s->path,
                        v->variant[i].line, v->variant[j].name, v->variant[i].name);
    }
}

static char *folder_of(const struct study_plan *p, const struct study_case *c, int repeat, const char *out) {
    char *method = study_text_slug(p->study->methods.variant[c->method].name),
         *level = study_text_slug(p->study->levels.variant[c->level].name);
    return arena_text("%s/runs/%s/%s/%s/%d", out, p->study->name, method, level, repeat + 1);
}

struct study_plan *study_plan_new(const struct study *s, const char *out) {
    struct study_plan *p = arena_new(1, sizeof *p);
    char *text = arena_keep(read_file(s->scene));
    if (!text) die_all(EXIT_CODE_SCENE, "%s: the scene %s cannot be read", s->path, s->scene);
    check_slugs(s, &s->methods);
    check_slugs(s, &s->levels);
    p->study = s;
    p->cases = s->levels.n * s->methods.n;
    p->at = arena_new((size_t)p->cases, sizeof *p->at);
    for (int i = 0; i < p->cases; i++) case_begin(&p->at[i], s, i / s->methods.n, i % s->methods.n, text);
    p->runs = p->cases * s->repeats;
    p->run = arena_new((size_t)p->runs, sizeof *p->run);
    for (int i = 0; i < p->runs; i++) {
        struct study_run *run = &p->run[i];
        run->at = i % p->cases;
        run->repeat = i / p->cases;
        run->resolved = p->at[run->at].resolved;
        if (s->members.n > 0) {
            run->member = s->members.text[run->repeat];
            run->resolved = resolve(s, &p->at[run->at], run->member, text);
            if (!run->resolved) exit(EXIT_CODE_SCENE);
        }
        run->folder = folder_of(p, &p->at[run->at], run->repeat, out);
        run->value = arena_new((size_t)s->quantities, sizeof *run->value);
        for (int q = 0; q < s->quantities; q++) run->value[q] = NAN;
    }
    return p;
}

/* Whether the folder's run is by the build, the ranks and the scene that the plan asks for. */
static int is_same(const struct study_plan *p, const struct study_run *run, const struct study_outcome *o) {
    char path[FOLDER_PATH];
    char *resolved = arena_keep(read_file(folder_path(path, run->folder, "scene.resolved.yaml")));
    return o->same_build && o->ranks == p->at[run->at].ranks && resolved && !strcmp(resolved, run->resolved);
}

void study_plan_read(const struct study_plan *p, struct study_run *run) {
    const struct study_outcome o = study_outcome_read(run->folder);
    run->reused = o.state != STUDY_TODO && is_same(p, run, &o);
    if (run->reused) run->outcome = o;
}

int study_plan_goes_on(const struct study_plan *p, const struct study_run *run) {
    const struct study_outcome o = study_outcome_read(run->folder);
    return o.state == STUDY_TODO && is_same(p, run, &o) && store_read_is_there(run->folder);
}

static double seconds_of(const struct study_outcome *o) { return o->wall + (isnan(o->setup) ? 0 : o->setup); }

double study_plan_left(const struct study_plan *p, int first) {
    double mean = 0, left = 0;
    int known = 0;
    for (int i = 0; i < p->runs; i++)
        if (p->run[i].outcome.state == STUDY_DONE) {
            mean += seconds_of(&p->run[i].outcome);
            known++;
        }
    if (known == 0) return NAN;
    mean /= known;
    for (int i = first; i < p->runs; i++) {
        if (p->run[i].outcome.state != STUDY_TODO) continue;
        double its = mean;
        for (int j = p->run[i].at; j < p->runs; j += p->cases)
            if (p->run[j].outcome.state == STUDY_DONE) its = seconds_of(&p->run[j].outcome);
        left += its;
    }
    return left;
}
