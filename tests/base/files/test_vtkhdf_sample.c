/* Writes sample field files for a VTK reader; vtk_reads.py checks them. */
/* Writes a run folder's fields as a run does, for VTK itself to read (vtk_reads.py has the same formulas). usage:
 * test_vtkhdf_sample FOLDER */
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/vtkhdf.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { NX = 6, NY = 4, NZ = 5, POINTS = 37 };

static void fluid(const char *folder, int step, double time) {
    char path[FOLDER_PATH], name[64];
    const int rank = par_rank(), lo = NZ * rank / par_size(), m = NZ * (rank + 1) / par_size() - lo;
    double(*u)[3] = malloc((size_t)(m * NX * NY + 1) * sizeof *u), *p = malloc((size_t)(m * NX * NY + 1) * sizeof *p);
    for (int k = 0; k < m; k++)
        for (int j = 0; j < NY; j++)
            for (int i = 0; i < NX; i++) {
                const int at = (k * NY + j) * NX + i;
                u[at][0] = i + step;
                u[at][1] = 10 * j;
                u[at][2] = -100 * (lo + k);
                p[at] = i + 10 * j + 100 * (lo + k);
            }
    snprintf(name, sizeof name, "fields/fluid_%08d.hdf", step);
    struct vtkhdf *f = vtkhdf_image_begin(&(struct vtkhdf_image_input){.path = folder_path(path, folder, name),
                                                                       .time = time,
                                                                       .step = step,
                                                                       .n = {NX, NY, NZ},
                                                                       .origin = {0.05, 0.1, 0.15},
                                                                       .spacing = {0.1, 0.2, 0.3},
                                                                       .lo = {0, 0, lo},
                                                                       .m = {NX, NY, m}});
    vtkhdf_add(f, "velocity", 3, (const double *)u);
    vtkhdf_add(f, "pressure", 1, p);
    vtkhdf_end(f);
    vtkhdf_series_add(folder_path(path, folder, "fields/fluid.hdf.series"), name + 7, time);
    free(u);
    free(p);
}

static void solid(const char *folder, int step, double time) {
    char path[FOLDER_PATH], name[64];
    const int rank = par_rank(), first = POINTS * rank / par_size(), n = POINTS * (rank + 1) / par_size() - first;
    double x[POINTS][3], damage[POINTS], stress[POINTS][6];
    int64_t id[POINTS];
    uint8_t body[POINTS];
    for (int i = 0; i < n; i++) {
        const int g = first + i;
        for (int c = 0; c < 3; c++) x[i][c] = g + 0.25 * c;
        for (int c = 0; c < 6; c++) stress[i][c] = g * 8 + c;
        damage[i] = (g + step) / 64.0;
        id[i] = g;
        body[i] = g % 2;
    }
    snprintf(name, sizeof name, "fields/solid_%08d.hdf", step);
    struct vtkhdf *f = vtkhdf_points_begin(&(struct vtkhdf_points_input){
        .path = folder_path(path, folder, name), .time = time, .step = step, .n = n, .x = (const double(*)[3])x});
    vtkhdf_add_long(f, "id", 1, id);
    vtkhdf_add_byte(f, "body", 1, body);
    vtkhdf_add(f, "damage", 1, damage);
    vtkhdf_add(f, "stress", 6, &stress[0][0]);
    vtkhdf_end(f);
    vtkhdf_series_add(folder_path(path, folder, "fields/solid.hdf.series"), name + 7, time);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc != 2) return 2;
    folder_make(argv[1]);
    folder_clear(argv[1]);
    for (int k = 0; k < 3; k++) {
        fluid(argv[1], 10 * k, 0.125 * k);
        solid(argv[1], 10 * k, 0.125 * k);
    }
    par_end();
    return 0;
}
