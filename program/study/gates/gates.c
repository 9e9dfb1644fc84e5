/* Reads a file of gates and does what it asks for. */
#include "program/study/gates/gates.h"
#include "base/die.h"
#include "base/arena.h"
#include "base/files/folder.h"
#include "base/files/read_file.h"
#include "program/study/file/key.h"
#include "program/study/gates/parts.h"
#include "scene/text/yaml.h"

#include <stdlib.h>
#include <string.h>

enum { MISSED = 1 }; /* exit code */

int study_gates_is(const char *path) {
    struct scene_node *root = read_file_is_special(path) ? NULL : scene_yaml_read(path);
    const int found = root && root->kind == SCENE_NODE_MAPPING && scene_node_child(root, "gates");
    scene_node_free(root);
    return found;
}

static void check(const struct scene_node *root, struct scene_problems *problems) {
    static const char *const top[] = {"title", "digits", "studies", "runs", "measured", "files", "gates"},
                             *const study[] = {"each", "when", "name"}, *const run[] = {"each",  "when", "name",
                                                                                        "scene", "set",  "command"},
                             *const file[] = {"each", "when", "command"}, *const measured[] = {"each",     "when",
                                                                                               "file",     "column",
                                                                                               "where",    "row",
                                                                                               "at",       "after",
                                                                                               "before",   "above",
                                                                                               "quantity", "factor",
                                                                                               "value",    "key",
                                                                                               "command"},
                             *const gate[] = {"each", "when",     "unit",    "reference", "source",  "quantity",
                                              "ours", "relative", "between", "at_least",  "at_most", "same"};
    const struct study_key k = {root, "", problems};
    if (!study_key_known(&k, sizeof top / sizeof *top, top)) return;
    study_key_whole(&k, "digits", 0, 17, 10);
    study_gates_items_check(root, "studies", sizeof study / sizeof *study, study, 2, problems);
    study_gates_items_check(root, "runs", sizeof run / sizeof *run, run, 2, problems);
    study_gates_items_check(root, "measured", sizeof measured / sizeof *measured, measured, 13, problems);
    study_gates_items_check(root, "files", sizeof file / sizeof *file, file, 2, problems);
    study_gates_items_check(root, "gates", sizeof gate / sizeof *gate, gate, 5, problems);
}

static struct scene_node *read(const char *path) {
    static const struct scene_yaml_what what = {"file of gates", "studies: ..., gates: ..."};
    struct scene_problems problems = {.file = path};
    char *text = arena_keep(read_file(path));
    struct scene_node *root = scene_yaml_parse_as(&what, text, strlen(text), &problems);
    if (root) check(root, &problems);
    scene_problem_sort(&problems);
    scene_problem_print(&problems);
    if (problems.n > 0) exit(EXIT_CODE_SCENE);
    scene_problem_free(&problems);
    return root;
}

static void make_folder(const char *path) {
    const int fault = folder_make_path(path);
    if (fault) die_all(EXIT_CODE_FILE, "%s: cannot be made: %s", path, strerror(fault));
}

int study_gates_run(const struct study_options *o, const char *program,
                    int (*study)(const struct study_options *o, const char *program)) {
    if (o->task != STUDY_ALL && o->task != STUDY_COLLECT)
        die_all(EXIT_CODE_SCENE, "study: --list and --run: %s has gates; give one of its studies", o->file);
    struct scene_node *root = read(o->file);
    const char *slash = strrchr(o->file, '/');
    char *folder = slash ? arena_text("%.*s", (int)(slash - o->file), o->file) : arena_text(".");
    struct study_gates g = {.path = o->file,
                            .folder = folder,
                            .program = program,
                            .quick = o->quick,
                            .collects = o->task == STUDY_COLLECT,
                            .fresh = o->fresh,
                            .study = study,
                            .root = root};
    g.results = o->results ? arena_text("%s", o->results) : arena_text("%s/results", folder);
    g.runs = arena_text("%s", o->out ? o->out : g.results);
    g.measured = arena_text("%s/measured.csv", g.quick ? g.runs : g.results);
    make_folder(g.runs);
    make_folder(g.results);
    if (!g.collects) study_gates_make(&g);
    const int missed = study_gates_judge(&g);
    scene_node_free(root);
    return missed ? MISSED : EXIT_CODE_DONE;
}
