/* Searches the particles near a position of a cloud, and the family of a particle, across periodic sides. */
#include "base/die.h"
#include "solid/body/cloud.h"

#include <math.h>

/* The cells that the interval x - reach .. x + reach overlaps in direction c; 0: none. */
static int range(const struct solid_cloud *cloud, int c, double x, double reach, int *from, int *to) {
    const double low = floor((x - reach - cloud->cells.low[c]) / cloud->cells.width),
                 high = floor((x + reach - cloud->cells.low[c]) / cloud->cells.width);
    const int last = cloud->cells.cells[c] - 1;
    if (high < 0 || low > last) return 0;
    *from = low < 0 ? 0 : (int)low;
    *to = high > last ? last : (int)high;
    return 1;
}

/* Visits the particles of one periodic image. */
static inline __attribute__((always_inline)) void visit_image(const struct solid_cloud *cloud, const double *place,
                                                              double reach, const int image[3],
                                                              solid_cloud_visitor *visit, void *with) {
    int from[3] = {0}, to[3] = {0};
    double shift[3] = {0};
    for (int c = 0; c < cloud->dim; c++) {
        shift[c] = image[c] * cloud->period[c];
        if (!range(cloud, c, place[c] - shift[c], reach, &from[c], &to[c])) return;
    }
    const int code = solid_cloud_image_code(image);
    for (int k = from[2]; k <= to[2]; k++)
        for (int j = from[1]; j <= to[1]; j++) {
            const long line = ((long)k * cloud->cells.cells[1] + j) * cloud->cells.cells[0];
            const long *start = cloud->cells.start + line;
            for (long q = start[from[0]]; q < start[to[0] + 1]; q++) {
                const long l = cloud->cells.item[q];
                double xi[3] = {0}, xi2 = 0;
                for (int c = 0; c < cloud->dim; c++) {
                    xi[c] = (cloud->place[c][l] - place[c]) + shift[c];
                    xi2 += xi[c] * xi[c];
                }
                if (xi2 <= reach * reach) visit(with, l, code, xi);
            }
        }
}

static inline __attribute__((always_inline)) void visit_all(const struct solid_cloud *cloud, const double *place,
                                                            double reach, solid_cloud_visitor *visit, void *with) {
    int image[3], most[3];
    for (int c = 0; c < 3; c++) most[c] = cloud->period[c] > 0;
    for (image[2] = -most[2]; image[2] <= most[2]; image[2]++)
        for (image[1] = -most[1]; image[1] <= most[1]; image[1]++)
            for (image[0] = -most[0]; image[0] <= most[0]; image[0]++)
                visit_image(cloud, place, reach, image, visit, with);
}

void solid_cloud_near_visit(const struct solid_cloud *cloud, const double place[3], double reach,
                            solid_cloud_visitor *visit, void *with) {
    visit_all(cloud, place, reach, visit, with);
}

static void find(void *found, long l, int image, const double *xi) {
    (void)l, (void)image, (void)xi;
    *(int *)found = 1;
}

int solid_cloud_near_holds(const struct solid_cloud *cloud, const double x[3]) {
    double place[3] = {0};
    int found = 0;
    for (int c = 0; c < cloud->dim; c++) place[c] = (x[c] - cloud->origin[c]) / cloud->spacing;
    visit_all(cloud, place, 0x1p-19, find, &found);
    return found;
}

struct search {
    const struct solid_cloud *cloud;
    long number;
    struct solid_end end;
    struct solid_cloud_near *near; /* NULL: particles are only counted */
    int n;
};

/* Whether there is a bond. A particle has no bond with itself, but may have bonds with its own images. */
static int is_bond(struct search *k, long l, int image, const double *xi) {
    if (l == k->number && image == SOLID_NO_IMAGE) return 0;
    const struct solid_end other = solid_cloud_end(k->cloud, l);
    if (xi[0] == 0 && xi[1] == 0 && xi[2] == 0)
        die(EXIT_CODE_SCENE, "two particles of solid body %s coincide", k->cloud->name);
    if (!solid_pair_exists(&k->cloud->law, xi, &k->end, &other)) return 0;
    if (k->n == SOLID_FAMILY_MAX)
        die(EXIT_CODE_SCENE, "a particle of solid body %s has more than %d neighbours", k->cloud->name,
            SOLID_FAMILY_MAX);
    return 1;
}

static void count(void *with, long l, int image, const double *xi) {
    struct search *k = with;
    if (is_bond(k, l, image, xi)) k->n++;
}

/* The order of a lattice's stencil: by z, then y, then x. */
static int comes_before(const double *a, const double *b) {
    return a[2] != b[2] ? a[2] < b[2] : a[1] != b[1] ? a[1] < b[1] : a[0] < b[0];
}

static void insert(void *with, long l, int image, const double *xi) {
    struct search *k = with;
    struct solid_cloud_near *near = k->near;
    if (!is_bond(k, l, image, xi)) return;
    int at = k->n++;
    for (; at > 0 && comes_before(xi, near->xi[at - 1]); at--) {
        near->number[at] = near->number[at - 1];
        near->image[at] = near->image[at - 1];
        for (int c = 0; c < 3; c++) near->xi[at][c] = near->xi[at - 1][c];
    }
    near->number[at] = l;
    near->image[at] = image;
    for (int c = 0; c < 3; c++) near->xi[at][c] = xi[c];
}

static struct search search_of(const struct solid_cloud *cloud, long i, double place[3]) {
    for (int c = 0; c < 3; c++) place[c] = c < cloud->dim ? cloud->place[c][i] : 0;
    return (struct search){.cloud = cloud, .number = i, .end = solid_cloud_end(cloud, i)};
}

void solid_cloud_near_find(const struct solid_cloud *cloud, long i, struct solid_cloud_near *near) {
    double place[3];
    struct search k = search_of(cloud, i, place);
    k.near = near;
    visit_all(cloud, place, cloud->longest_reach, insert, &k);
    near->n = k.n;
}

int solid_cloud_near_count(const struct solid_cloud *cloud, long i) {
    double place[3];
    struct search k = search_of(cloud, i, place);
    visit_all(cloud, place, cloud->longest_reach, count, &k);
    return k.n;
}
