/* Reads every finished file of a run folder and names the damaged ones. */
/* Reads every finished file of a run folder from end to end: none may be damaged, whatever fault the run had. Prints
 * the damaged ones. usage: look RUNDIR */
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/seal.h"
#include "base/files/table.h"
#include "base/files/vtkhdf.h"

#include <dirent.h>
#include <hdf5.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static int damaged, files;

static void report(const char *path, const char *why) {
    printf("%s: %s\n", path, why);
    damaged++;
}

static int ends_with(const char *name, const char *end) {
    const size_t n = strlen(name), e = strlen(end);
    return n > e && !strcmp(name + n - e, end);
}

static void look_checkpoint(const char *path) {
    char why[256];
    if (seal_file_check(path, why, sizeof why)) report(path, why);
}

/* Reads all values of all fields; the length of the file must be the one that HDF5 expects. */
static void look_field(const char *path) {
    const char *error = NULL;
    struct stat is;
    haddr_t end = 0;
    struct vtkhdf_source *s = vtkhdf_read_open(path, &error);
    if (!s) {
        report(path, error ? error : "cannot be opened");
        return;
    }
    if (s->fields == 0) report(path, "has no field");
    for (int k = 0; k < s->fields; k++) {
        void *value = s->field[k].integer ? (void *)vtkhdf_read_long(s, s->field[k].name)
                                          : (void *)vtkhdf_read_double(s, s->field[k].name);
        if (!value) report(path, s->field[k].name);
        free(value);
    }
    vtkhdf_read_close(s);
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0 || H5Fget_eoa(file, &end) < 0 || stat(path, &is) != 0 || (haddr_t)is.st_size != end)
        report(path, "is of another length than HDF5 wrote");
    if (file >= 0) H5Fclose(file);
}

/* Checks that each listed file exists. */
static void look_series(const char *path, const char *folder) {
    struct vtkhdf_series_entry *list = NULL;
    char file[FOLDER_PATH];
    struct stat is;
    const int n = vtkhdf_series_read(path, &list);
    if (n < 0) report(path, "cannot be read");
    for (int k = 0; k < n; k++)
        if (stat(folder_path(file, folder, list[k].file), &is) != 0) report(path, list[k].file);
    free(list);
}

static void look_folder(const char *run, const char *part) {
    char folder[FOLDER_PATH], path[FOLDER_PATH];
    DIR *dir = opendir(folder_path(folder, run, part));
    for (struct dirent *entry; dir && (entry = readdir(dir));) {
        folder_path(path, folder, entry->d_name);
        if (ends_with(path, ".h5"))
            look_checkpoint(path);
        else if (ends_with(path, ".hdf"))
            look_field(path);
        else if (ends_with(path, ".hdf.series"))
            look_series(path, folder);
        else
            continue;
        files++;
    }
    if (dir) closedir(dir);
}

/* Checks that the name in it is that of a checkpoint. */
static void look_latest(const char *run) {
    char path[FOLDER_PATH], name[256] = "", other[FOLDER_PATH], file[FOLDER_PATH];
    struct stat is;
    FILE *f = fopen(folder_path(path, run, "checkpoint/latest"), "r");
    if (!f) return;
    if (fscanf(f, "%255[^\n]", name) != 1 ||
        stat(folder_path(file, folder_path(other, run, "checkpoint"), name), &is) != 0)
        report(path, "names no checkpoint");
    fclose(f);
    files++;
}

/* Checks that all rows, except one that was being written, are complete. */
static void look_table(const char *run, const char *name) {
    char path[FOLDER_PATH];
    const char *error = NULL;
    struct stat is;
    if (stat(folder_path(path, run, name), &is) != 0 || is.st_size == 0) return;
    struct table_data *d = table_read(path, &error);
    if (!d) report(path, error);
    table_read_free(d);
    files++;
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc != 2) return 2;
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    look_folder(argv[1], "checkpoint");
    look_folder(argv[1], "fields");
    look_latest(argv[1]);
    look_table(argv[1], "series.csv");
    look_table(argv[1], "probes.csv");
    printf("%d files, %d damaged\n", files, damaged);
    par_end();
    return damaged > 0;
}
