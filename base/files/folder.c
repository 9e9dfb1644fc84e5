/* Makes, clears and inspects the run folder. */
#include "base/files/folder.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/par_hdf5.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *const part_folder[] = {"fields", "checkpoint"};
/* Files of every run; folder_own adds those of its outputs. */
enum { FOLDERS = sizeof part_folder / sizeof *part_folder, FILES_MAX = 64 };
static const char *part_file[FILES_MAX] = {"series.csv", "solution.csv", "run.json", "run.log", "scene.resolved.yaml"};
static int part_files = 5;

void folder_own(const char *name) {
    for (int k = 0; k < part_files; k++)
        if (!strcmp(part_file[k], name)) return;
    ENSURE(part_files < FILES_MAX, "more than %d files of a run: %s", FILES_MAX, name);
    part_file[part_files++] = name;
}

char *folder_path(char *path, const char *folder, const char *name) {
    if (snprintf(path, FOLDER_PATH, "%s/%s", folder, name) >= FOLDER_PATH)
        die(EXIT_CODE_FILE, "%s/%s: the name is too long", folder, name);
    return path;
}

int folder_make_path(const char *folder) {
    char path[FOLDER_PATH];
    snprintf(path, sizeof path, "%s", folder);
    for (char *at = path + 1;; at++) {
        if (*at != '/' && *at != '\0') continue;
        const char end = *at;
        *at = '\0';
        if (mkdir(path, 0777) != 0 && errno != EEXIST) return errno;
        if (end == '\0') return 0;
        *at = end;
    }
}

/* The same, and whether it can be written to; 0 or errno. */
static int make(const char *folder) {
    const int fault = folder_make_path(folder);
    if (fault != 0) return fault;
    struct stat is;
    if (stat(folder, &is) != 0) return errno;
    if (!S_ISDIR(is.st_mode)) return ENOTDIR;
    return access(folder, W_OK | X_OK) == 0 ? 0 : errno;
}

/* All ranks get rank 0's errno. */
static int agree(int fault) {
    par_bcast(&fault, sizeof fault, 0);
    return fault;
}

void folder_make(const char *folder) {
    char path[FOLDER_PATH];
    int fault = 0;
    if (strlen(folder) == 0 || strlen(folder) + 16 >= FOLDER_PATH)
        die_all(EXIT_CODE_FILE, "run folder \"%s\": the name is empty or too long", folder);
    if (par_rank() == 0) {
        fault = make(folder);
        for (int k = 0; k < FOLDERS && !fault; k++) fault = make(folder_path(path, folder, part_folder[k]));
    }
    fault = agree(fault);
    if (fault) die_all(EXIT_CODE_FILE, "run folder %s: cannot be made or written: %s", folder, strerror(fault));
    if (par_size() > 1 && strchr(folder, ':') && !par_hdf5_opens(folder_path(path, folder, "checkpoint/try.part")))
        die_all(EXIT_CODE_FILE,
                "run folder %s: the MPI library cannot open a file whose path has a colon: choose a name without one",
                folder);
}

/* Calls the function on each regular file of a folder; returns how many there are. */
static int each_file(const char *folder, void (*call)(const char *path)) {
    char path[FOLDER_PATH];
    int files = 0;
    DIR *dir = opendir(folder);
    for (struct dirent *entry; dir && (entry = readdir(dir));) {
        struct stat is;
        if (lstat(folder_path(path, folder, entry->d_name), &is) != 0 || !S_ISREG(is.st_mode)) continue;
        files++;
        if (call) call(path);
    }
    if (dir) closedir(dir);
    return files;
}

int folder_has_run(const char *folder) {
    char path[FOLDER_PATH];
    int has = 0;
    if (par_rank() == 0) {
        has = access(folder_path(path, folder, "series.csv"), F_OK) == 0 ||
              access(folder_path(path, folder, "run.json"), F_OK) == 0 ||
              access(folder_path(path, folder, "solution.csv"), F_OK) == 0;
        for (int k = 0; k < FOLDERS && !has; k++) has = each_file(folder_path(path, folder, part_folder[k]), NULL) > 0;
    }
    return agree(has);
}

/* A name in a run folder that a run makes; the names of files that are being written too. */
static int is_runs(const char *name) {
    const char *const others[] = {"run.lock", "unfinished_", "screen.log"};
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
        if (!strncmp(name, others[k], strlen(others[k]))) return 1;
    for (int k = 0; k < FOLDERS; k++)
        if (!strcmp(name, part_folder[k])) return 1;
    for (int k = 0; k < part_files; k++) {
        const size_t n = strlen(part_file[k]);
        if (!strncmp(name, part_file[k], n) && (!name[n] || !strcmp(name + n, ".part"))) return 1;
    }
    return 0;
}

int folder_is_foreign(const char *folder) {
    int own = 0, other = 0;
    DIR *dir = par_rank() == 0 ? opendir(folder) : NULL;
    for (struct dirent *entry; dir && (entry = readdir(dir));) {
        if (!strcmp(entry->d_name, ".") || !strcmp(entry->d_name, "..")) continue;
        if (is_runs(entry->d_name))
            own = 1;
        else
            other = 1;
    }
    if (dir) closedir(dir);
    return agree(other && !own);
}

/* Moves folder/name to archive/name, if there is one; 0 or errno. */
static int move(const char *folder, const char *archive, const char *name) {
    char from[FOLDER_PATH], to[FOLDER_PATH];
    return rename(folder_path(from, folder, name), folder_path(to, archive, name)) == 0 || errno == ENOENT ? 0 : errno;
}

void folder_archive(const char *folder, char *archive) {
    char name[32];
    int fault = 0;
    if (par_rank() == 0) {
        for (int k = 1; fault == 0 || fault == EEXIST; k++) {
            snprintf(name, sizeof name, "unfinished_%d", k);
            fault = mkdir(folder_path(archive, folder, name), 0777) == 0 ? 0 : errno;
            if (fault == 0) break;
        }
        for (int k = 0; k < FOLDERS && !fault; k++) fault = move(folder, archive, part_folder[k]);
        for (int k = 0; k < part_files && !fault; k++) fault = move(folder, archive, part_file[k]);
    }
    fault = agree(fault);
    par_bcast(archive, FOLDER_PATH, 0);
    if (fault)
        die_all(EXIT_CODE_FILE, "%s: the files of an unfinished run cannot be moved: %s", archive, strerror(fault));
}

static void delete_file(const char *path) {
    const char *name = strrchr(path, '/') + 1;
    const char *const ending[] = {".hdf", ".hdf.series", ".h5", ".part", "latest"};
    for (int k = 0; k < 5; k++) {
        const size_t n = strlen(name), e = strlen(ending[k]);
        if (n >= e && strcmp(name + n - e, ending[k]) == 0) {
            unlink(path);
            return;
        }
    }
}

static void delete_part(const char *path) {
    const size_t n = strlen(path);
    if (n > 5 && !strcmp(path + n - 5, ".part")) delete_file(path);
}

void folder_clear_parts(const char *folder) {
    char name[64], path[FOLDER_PATH];
    if (par_rank() == 0) {
        for (int k = 0; k < part_files; k++) {
            snprintf(name, sizeof name, "%s.part", part_file[k]);
            unlink(folder_path(path, folder, name));
        }
        for (int k = 0; k < FOLDERS; k++) each_file(folder_path(path, folder, part_folder[k]), delete_part);
    }
    par_barrier();
}

void folder_clear(const char *folder) {
    char path[FOLDER_PATH];
    if (par_rank() == 0) {
        for (int k = 0; k < part_files; k++) unlink(folder_path(path, folder, part_file[k]));
        for (int k = 0; k < FOLDERS; k++) each_file(folder_path(path, folder, part_folder[k]), delete_file);
    }
    par_barrier();
}
