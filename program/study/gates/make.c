/* Makes the studies and runs of a case, and measures its numbers. */
#include "base/die.h"
#include "base/launcher.h"
#include "base/arena.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "base/files/plain_file.h"
#include "base/files/read_file.h"
#include "program/study/file/parts.h"
#include "program/study/gates/parts.h"
#include "program/study/runs/child.h"

#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WORDS_MAX = 200 };

static void copy(const char *from, const char *folder) {
    char path[FOLDER_PATH], block[1 << 16];
    const char *slash = strrchr(from, '/');
    FILE *in = plain_file_read(from);
    if (!in) die_all(EXIT_CODE_FILE, "%s: cannot be read: %s", from, plain_file_why(errno));
    struct atomic_write out;
    atomic_write_begin(&out, folder_path(path, folder, slash ? slash + 1 : from));
    for (size_t n; (n = fread(block, 1, sizeof block, in)) > 0;) fwrite(block, 1, n, out.file);
    if (ferror(in)) die_all(EXIT_CODE_FILE, "%s: cannot be read", from);
    fclose(in);
    atomic_write_end(&out);
}

/* Copies the tables and plots of a study to the results. */
static void copy_tables(const struct study_gates *g, const char *name) {
    static const char *const ending[] = {".csv", ".md", "*.png"};
    for (size_t k = 0; k < sizeof ending / sizeof *ending; k++) {
        glob_t found;
        if (glob(arena_text("%s/%s%s", g->runs, name, ending[k]), 0, NULL, &found) == 0)
            for (size_t i = 0; i < found.gl_pathc; i++) copy(found.gl_pathv[i], g->results);
        globfree(&found);
    }
}

static void make_study(const struct scene_node *item, const struct study_gates_name *names, void *with) {
    const struct study_gates *g = with;
    char *name = study_gates_items_text(item, "name", names);
    if (!name) die_all(EXIT_CODE_SCENE, "%s:%d: a study needs a name", g->path, item->line);
    char *file = arena_text("%s/%s.yaml", g->folder, name);
    const int code = g->study(&(struct study_options){.file = file, .out = g->runs, .fresh = g->fresh}, g->program);
    if (code != EXIT_CODE_DONE) exit(code);
    if (!g->quick && strcmp(g->runs, g->results) != 0) copy_tables(g, name);
}

/* The child's output goes to a file of this name in the folder of runs; dies if it fails. */
static void must(const struct study_gates *g, char *const *argv, const char *folder, const char *output) {
    char path[FOLDER_PATH], errors[FOLDER_PATH];
    char *top = arena_keep(realpath(g->runs, NULL));
    folder_path(path, top, output);
    folder_path(errors, top, "gates.log");
    const int code = study_child_run(&(struct study_child){argv, folder, path, errors});
    if (study_child_stopped()) {
        fprintf(stderr, "frana: %s: stopped: the same command goes on\n", g->path);
        exit(EXIT_CODE_REQUEUE);
    }
    if (code != 0)
        die_all(EXIT_CODE_FILE, "%s: a command ended with exit code %d; %s and %s hold what it said", g->path, code,
                path, errors);
}

/* Takes away the quotes around "{name}", in place: what a name stands for is written as it is. */
static void bare_names(char *text) {
    char *to = text;
    int in_name = 0;
    for (const char *at = text; *at; at++) {
        if (at[0] == '"' && at[1] == '{' && strstr(at, "}\"")) {
            in_name = 1;
            continue;
        }
        if (at[0] == '"' && in_name && at[-1] == '}') {
            in_name = 0;
            continue;
        }
        *to++ = *at;
    }
    *to = '\0';
}

/* --set words of the mapping `set`, with the names replaced. */
static int add_sets(char **word, int n, const struct scene_node *item, const struct study_gates_name *names) {
    const struct scene_node *set = scene_node_child(item, "set");
    struct study_sets sets = {0};
    struct scene_problems problems = {0};
    if (set) study_sets_read(&sets, set, "set", &problems);
    for (int i = 0; i < sets.n && n + 3 < WORDS_MAX; i++) {
        struct scene_node *pair = scene_node_new(SCENE_NODE_MAPPING, NULL, NULL);
        bare_names(sets.text[i]);
        scene_node_append(pair, scene_node_new(SCENE_NODE_SCALAR, "set", sets.text[i]));
        word[n++] = arena_text("--set");
        word[n++] = study_gates_items_text(pair, "set", names);
        scene_node_free(pair);
    }
    return n;
}

/* A command in the folder of runs; what it prints goes to the file `output` there. */
static void make_command(const struct study_gates *g, char *command, const char *output) {
    char *argv[] = {"sh", "-c", command, NULL};
    must(g, argv, g->runs, output);
}

static void make_scene(const struct study_gates *g, const struct scene_node *item, const struct study_gates_name *names,
                       const char *name, const char *scene) {
    char *word[WORDS_MAX] = {arena_text("%s", g->program), arena_text("run"),   arena_text("%s/%s", g->folder, scene),
                             arena_text("--quiet"),        arena_text("--out"), arena_text("%s/%s", g->runs, name)};
    char *clear[] = {"rm", "-rf", word[5], NULL}, *log = arena_text("%s.log", name);
    must(g, clear, NULL, log);
    add_sets(word, 6, item, names);
    must(g, word, NULL, log);
}

static void make_run(const struct scene_node *item, const struct study_gates_name *names, void *with) {
    const struct study_gates *g = with;
    char *name = study_gates_items_text(item, "name", names), *scene = study_gates_items_text(item, "scene", names),
         *command = study_gates_items_text(item, "command", names);
    if (!command && (!name || !scene))
        die_all(EXIT_CODE_SCENE, "%s:%d: a run needs name and scene, or command", g->path, item->line);
    if (command)
        make_command(g, command, "runs.txt");
    else
        make_scene(g, item, names, name, scene);
}

/* The last line of a file, without blanks at its end. */
static char *last_line(const char *path) {
    char *text = arena_keep(read_file(path));
    size_t end = text ? strlen(text) : 0;
    while (end > 0 && strchr(" \t\r\n", text[end - 1])) text[--end] = '\0';
    const char *line = text ? strrchr(text, '\n') : NULL;
    return arena_text("%s", line ? line + 1 : text ? text : "");
}

/* What the command of an item prints at last. */
static char *of_command(const struct study_gates *g, const struct scene_node *item,
                        const struct study_gates_name *names) {
    char path[FOLDER_PATH], *command = study_gates_items_text(item, "command", names);
    if (!command) die_all(EXIT_CODE_SCENE, "%s:%d: a number needs command, file or value", g->path, item->line);
    make_command(g, command, "measured.txt");
    return last_line(folder_path(path, g->runs, "measured.txt"));
}

/* Arithmetic with numbers that were measured before it, and cells of studies. */
static char *of_arithmetic(const struct study_gates *g, const struct scene_node *item, const char *text) {
    const struct study_gates_values values = {g->path, g->runs, g->measured};
    return study_gates_values_text(&values, text, item->line);
}

static void measure(const struct scene_node *item, const struct study_gates_name *names, void *with) {
    const struct study_gates *g = with;
    char *key = study_gates_items_text(item, "key", names);
    if (!key) die_all(EXIT_CODE_SCENE, "%s:%d: a number needs a key", g->path, item->line);
    char *arithmetic = study_gates_items_text(item, "value", names),
         *file = study_gates_items_text(item, "file", names),
         *value = arithmetic ? of_arithmetic(g, item, arithmetic)
                  : file     ? study_gates_cell_text(g, item, names)
                             : of_command(g, item, names);
    FILE *f = fopen(g->measured, "a");
    if (!f || fprintf(f, "\"%s\",%s\n", key, value) < 0 || fclose(f) != 0)
        die_all(EXIT_CODE_FILE, "%s: cannot be written", g->measured);
}

static void environment(const struct study_gates *g) {
    char *folder = arena_keep(realpath(g->folder, NULL)),
         *results = arena_keep(realpath(g->quick ? g->runs : g->results, NULL));
    setenv("FRANA", g->program, 1);
    setenv("FRANA_STUDY", folder ? folder : g->folder, 1);
    setenv("FRANA_RESULTS", results ? results : g->results, 1);
    launcher_allow();
}

static void visit(const struct study_gates *g, const char *list,
                  void (*item)(const struct scene_node *, const struct study_gates_name *, void *)) {
    struct study_gates copy_of = *g;
    const struct study_gates_visit v = {item, &copy_of, list, g->quick};
    study_gates_items_visit(scene_node_child(g->root, list), NULL, &v);
}

void study_gates_make(const struct study_gates *g) {
    visit(g, "studies", make_study);
    environment(g);
    study_child_begin();
    unlink(g->measured);
    visit(g, "runs", make_run);
    visit(g, "measured", measure);
    visit(g, "files", make_run);
}
