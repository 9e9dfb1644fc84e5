/* frana init: copies the scene of a case, with a comment on each key that stands on a line of its own. */
#include "program/init.h"
#include "base/die.h"
#include "base/text.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "frana_cases.h"
#include "program/grains.h"
#include "scene/keys/describe.h"
#include "scene/text/problem.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LINE = 4096, LEVELS = 32, COLUMNS = 110 };

/* Scenes that need no other file but one that is made here, the least first: the name, and where cases/ holds the
 * scene. */
static const struct {
    const char *name, *path;
} scene[] = {{"channel", "channel/scene.yaml"},
             {"porous_channel", "porous_channel/demo.yaml"},
             {"rock", "berea/rock.yaml"},
             {"sphere_array", "sphere_array/scene.yaml"},
             {"bar", "bar/scene.yaml"},
             {"plate_hole", "plate_hole/a.yaml"},
             {"soda_lime", "soda_lime/scene.yaml"},
             {"duran_50", "duran_50/scene.yaml"},
             {"kalthoff", "kalthoff/x2nicomo.yaml"},
             {"plate_wave", "plate_wave/scene.yaml"},
             {"notched_beam", "verification/notched_beam/scene.yaml"},
             {"impact_disc", "verification/impact_disc/small.yaml"},
             {"interface", "verification/interface/strip.yaml"},
             {"element_free", "verification/element_free/scene.yaml"},
             {"hydraulic_fracture", "verification/hydraulic_fracture/toughness.yaml"}};
enum { SCENES = sizeof scene / sizeof *scene };

/* Where the scenes are: installed beside the program, in share/frana/examples/NAME.yaml, or in the sources that it was
 * built from. */
static void path_of(int k, char path[FOLDER_PATH]) {
    char program[FOLDER_PATH] = "";
    const ssize_t n = readlink("/proc/self/exe", program, sizeof program - 1);
    char *slash = n > 0 ? strrchr(program, '/') : NULL;
    if (slash) {
        *slash = '\0';
        if (snprintf(path, FOLDER_PATH, "%s/../share/frana/examples/%s.yaml", program, scene[k].name) < FOLDER_PATH &&
            access(path, R_OK) == 0)
            return;
    }
    snprintf(path, FOLDER_PATH, "%s/%s", FRANA_CASES, scene[k].path);
}

/* The title of a scene; "" if it cannot be read. */
static void title_of(int k, char title[LINE]) {
    char path[FOLDER_PATH];
    path_of(k, path);
    FILE *file = fopen(path, "r");
    *title = '\0';
    while (file && fgets(title, LINE, file) && strncmp(title, "title: ", 7) != 0) *title = '\0';
    if (file) fclose(file);
    if (*title) memmove(title, title + 7, strlen(title + 7) + 1);
    title[strcspn(title, "\n")] = '\0';
}

static int list(void) {
    char title[LINE];
    int n = 0;
    puts("cases (frana init CASE copies the scene):");
    for (int k = 0; k < SCENES; k++) {
        title_of(k, title);
        if (*title) printf("  %-20s %s\n", scene[k].name, title), n++;
    }
    if (n == 0)
        die_all(EXIT_CODE_FILE, "the cases are neither in share/frana/examples beside the program nor in %s",
                FRANA_CASES);
    return EXIT_CODE_DONE;
}

/* The place in a scene that the walk over its lines has reached. */
struct place {
    int n;
    struct {
        int indent;
        char path[256];
    } level[LEVELS];
    char *seen; /* the paths that have their comment: "\npath\n..." */
};

/* Moves to the key that begins the line at this column; whether its path is new. */
static int enter_key(struct place *p, int indent, const char *key, int length) {
    while (p->n > 0 && p->level[p->n - 1].indent >= indent) p->n--;
    if (p->n == LEVELS) return 0;
    char above[sizeof p->level[0].path] = "";
    if (p->n) memcpy(above, p->level[p->n - 1].path, sizeof above);
    snprintf(p->level[p->n].path, sizeof p->level[0].path, "%.200s%s%.*s", above, *above ? "." : "", length, key);
    p->level[p->n].indent = indent;
    char *line = text_new("\n%s\n", p->level[p->n++].path);
    const int is_new = !strstr(p->seen, line);
    if (is_new) {
        char *longer = text_new("%s%s", p->seen, line);
        free(p->seen);
        p->seen = longer;
    }
    free(line);
    return is_new;
}

/* [text](page) becomes text, in place. */
static void remove_links(char *what) {
    char *to = what;
    for (const char *from = what; *from;) {
        const char *middle = *from == '[' ? strstr(from, "](") : NULL, *end = middle ? strchr(middle, ')') : NULL;
        if (end && (size_t)(middle - from) == strcspn(from, "] ")) {
            memmove(to, from + 1, (size_t)(middle - from) - 1);
            to += middle - from - 1;
            from = end + 1;
        } else
            *to++ = *from++;
    }
    *to = 0;
}

/* Writes what docs/scene.md says of the key as a comment of one or more lines. */
static void comment(FILE *to, const char *path, int indent) {
    char *what = scene_describe_key(path);
    if (what) remove_links(what);
    int at = 0;
    for (const char *word = what; word && *word;) {
        const int n = (int)strcspn(word, " ");
        if (at == 0 || at + n + 1 > COLUMNS) at = fprintf(to, "%s%*s#", at ? "\n" : "", indent, "") - (at > 0);
        at += fprintf(to, " %.*s", n, word);
        word += n + (word[n] == ' ');
    }
    if (at) fputc('\n', to);
    free(what);
}

/* Copies a line, after a comment on its first key. Keys inside braces have none. */
static void copy_line(FILE *to, struct place *p, const char *line) {
    int indent = (int)strspn(line, " ");
    const int first = indent;
    if (line[indent] == '-' && line[indent + 1] == ' ') { /* an entry of the list above */
        while (p->n > 0 && p->level[p->n - 1].indent > indent) p->n--;
        if (p->n > 0 && p->n < LEVELS) {
            char above[sizeof p->level[0].path];
            memcpy(above, p->level[p->n - 1].path, sizeof above);
            if (strlen(above) < 3 || strcmp(above + strlen(above) - 2, "[]") != 0) {
                snprintf(p->level[p->n].path, sizeof p->level[0].path, "%.200s[]", above);
                p->level[p->n++].indent = indent;
            }
        }
        indent += 2;
    }
    const int length = (int)strspn(line + indent, "abcdefghijklmnopqrstuvwxyz_0123456789");
    if (length > 0 && line[indent + length] == ':' && enter_key(p, indent, line + indent, length))
        comment(to, p->level[p->n - 1].path, first);
    fputs(line, to);
}

static void copy(FILE *from, FILE *to, const char *name) {
    char line[LINE];
    struct place p = {.seen = text_new("%s", "")};
    fprintf(
        to,
        "# The scene of the case %s. All lengths are in m, all units SI. Every key: docs/scene.md, or `frana keys`.\n",
        name);
    fprintf(to,
            "#   frana check %s.yaml                      what the run will hold, its steps, memory, files and time\n",
            name);
    fprintf(to, "#   mpiexec -n 2 frana run %s.yaml           runs it on two ranks into runs/%s\n", name, name);
    fprintf(to, "#   frana post runs/%s                       plots and pictures\n", name);
    while (fgets(line, sizeof line, from)) copy_line(to, &p, line);
    free(p.seen);
}

/* The image that the scene rock names. */
static void write_image(const char *folder) {
    char path[FOLDER_PATH];
    struct stat info;
    struct atomic_write a;
    if (stat(folder_path(path, folder, "rock.raw"), &info) == 0)
        die_all(EXIT_CODE_SCENE, "%s: is there already, and is not overwritten", path);
    atomic_write_begin(&a, path);
    grains_write(a.file);
    atomic_write_end(&a);
}

int init_scene(const char *name, const char *folder) {
    const char *known[SCENES];
    char from[FOLDER_PATH], to[FOLDER_PATH], file[128];
    struct stat info;
    struct atomic_write a;
    int k = 0;
    if (!name) return list();
    while (k < SCENES && strcmp(scene[k].name, name) != 0) k++;
    for (int i = 0; i < SCENES; i++) known[i] = scene[i].name;
    if (k == SCENES) {
        const char *nearest = scene_problem_nearest(name, SCENES, known);
        die_all(EXIT_CODE_SCENE, "init %s: there is no such case; %s%s%sfrana init lists the cases", name,
                nearest ? "did you mean " : "", nearest ? nearest : "", nearest ? "? " : "");
    }
    path_of(k, from);
    FILE *source = fopen(from, "r");
    if (!source) die_all(EXIT_CODE_FILE, "%s: cannot be read: %s", from, strerror(errno));
    if (strlen(folder) > FOLDER_PATH - sizeof file) die_all(EXIT_CODE_SCENE, "%s: the name is too long", folder);
    const int fault = folder_make_path(folder);
    if (fault) die_all(EXIT_CODE_FILE, "%s: cannot be made: %s", folder, strerror(fault));
    snprintf(file, sizeof file, "%s.yaml", name);
    if (stat(folder_path(to, folder, file), &info) == 0)
        die_all(EXIT_CODE_SCENE, "%s: is there already, and is not overwritten", to);
    if (strcmp(name, "rock") == 0) write_image(folder);
    atomic_write_begin(&a, to);
    copy(source, a.file, name);
    atomic_write_end(&a);
    fclose(source);
    printf("%s; next: frana check %s\n", to, to);
    return EXIT_CODE_DONE;
}
