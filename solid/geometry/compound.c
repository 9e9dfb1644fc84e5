/* Unites shapes, holes, cavities and periodic images to one surface, and finds the depth of a place below it. */
#include "solid/geometry/compound.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "solid/geometry/on_surface.h"

#include <limits.h>
#include <math.h>
#include <string.h>

static const double MARGIN = 2;         /* spacings beyond its bounds within which a member is near */
static const double SMALL = 2;          /* spacings, the longest side of the bounds of a small member */
static const double MARGIN_SMALL = 0.5; /* the same as MARGIN, of a small member */
enum { CELLS_MAX = 4096 };              /* in one direction */
static const double SITES_MAX = 1e6;    /* of a body, in one direction */

/* Calls for each convex shape of a body and of its parts. */
typedef void visitor(void *with, const struct solid_body *convex, int is_hole);

static void visit_one(const struct solid_body *body, int is_hole, visitor *visit, void *with) {
    const struct solid_shape_kind *kind = solid_shape_of(body);
    if (!kind->entry) {
        visit(with, body, is_hole);
        return;
    }
    for (long k = 0; k < body->entries; k++) {
        struct solid_body entry;
        kind->entry(body, k, &entry);
        visit(with, &entry, is_hole);
    }
}

static void visit_all(const struct solid_body *body, visitor *visit, void *with) {
    visit_one(body, 0, visit, with);
    for (int p = 0; p < body->parts; p++) visit_one(&body->part[p], body->part[p].is_hole, visit, with);
}

struct counting {
    struct solid_compound *c;
    const struct solid_input *in;
    long members, pieces; /* with the images */
};

static void extend(void *with, const struct solid_body *convex, int is_hole) {
    struct solid_compound *c = ((struct counting *)with)->c;
    double low[3], high[3];
    if (is_hole) return;
    ENSURE(c->shapes < INT_MAX, "a body of %d shapes", c->shapes);
    c->shapes++;
    solid_shape_of(convex)->bounds(convex, low, high);
    for (int d = 0; d < 3; d++) {
        c->low[d] = fmin(c->low[d], low[d]);
        c->high[d] = fmax(c->high[d], high[d]);
    }
}

/* The images of a shape that are near the domain: from[d] to to[d] periods. Holes have images across all periodic
 * sides. */
static void images_of(const struct solid_compound *c, const struct solid_input *in, const struct solid_body *convex,
                      int is_hole, int from[3], int to[3]) {
    double low[3], high[3];
    solid_shape_of(convex)->bounds(convex, low, high);
    for (int d = 0; d < 3; d++) {
        from[d] = to[d] = 0;
        if (is_hole ? !in->periodic[d] : !c->is_wrapped[d]) continue;
        from[d] = (int)ceil((-MARGIN * c->spacing - high[d]) / in->length[d]);
        to[d] = (int)floor((in->length[d] + MARGIN * c->spacing - low[d]) / in->length[d]);
    }
}

static void count(void *with, const struct solid_body *convex, int is_hole) {
    struct counting *n = with;
    struct solid_piece piece[SOLID_PIECES_MAX];
    int from[3], to[3];
    images_of(n->c, n->in, convex, is_hole, from, to);
    long images = 1;
    for (int d = 0; d < 3; d++) images *= to[d] < from[d] ? 0 : to[d] - from[d] + 1;
    n->members += images;
    n->pieces += images * solid_shape_of(convex)->pieces(convex, piece);
}

/* A small member is near fewer places: it is in fewer cells, and fewer depths below it are computed. It must be such
 * that nothing asks for it from afar: no hole, no cavity, and below its one piece is inside it. */
static int is_small(const struct solid_compound *c, const struct solid_compound_member *m) {
    for (int d = 0; d < 3; d++)
        if (!(m->high[d] - m->low[d] <= SMALL * c->spacing)) return 0;
    return m->pieces == 1 && !m->is_hole && !(c->cavities.period > 0);
}

static double margin_of(const struct solid_compound *c, const struct solid_compound_member *m) {
    return (m->is_small ? MARGIN_SMALL : MARGIN) * c->spacing;
}

static void add_image(struct counting *n, const struct solid_body *convex, int is_hole, const int image[3]) {
    struct solid_compound *c = n->c;
    struct solid_compound_member *m = &c->member[c->members++];
    struct solid_piece *piece = c->piece + n->pieces;
    solid_shape_of(convex)->bounds(convex, m->low, m->high);
    m->first = n->pieces;
    m->pieces = solid_shape_of(convex)->pieces(convex, piece);
    m->is_hole = is_hole;
    m->shape = c->shapes;
    n->pieces += m->pieces;
    for (int d = 0; d < 3; d++) {
        m->shift[d] = image[d] == 0 ? 0 : image[d] * n->in->length[d];
        m->low[d] += m->shift[d];
        m->high[d] += m->shift[d];
        for (int k = 0; k < m->pieces; k++) piece[k].centre[d] += m->shift[d];
    }
    for (int k = 0; k < m->pieces && is_hole; k++) piece[k].inside = -piece[k].inside;
    m->is_small = is_small(c, m);
    c->small += m->is_small;
}

static void add(void *with, const struct solid_body *convex, int is_hole) {
    struct counting *n = with;
    int from[3], to[3], at[3];
    images_of(n->c, n->in, convex, is_hole, from, to);
    for (at[2] = from[2]; at[2] <= to[2]; at[2]++)
        for (at[1] = from[1]; at[1] <= to[1]; at[1]++)
            for (at[0] = from[0]; at[0] <= to[0]; at[0]++) add_image(n, convex, is_hole, at);
    n->c->shapes += !is_hole;
}

/* The cells that a member reaches into. */
static void cells_of(const struct solid_compound *c, const struct solid_compound_member *m, int from[3], int to[3]) {
    for (int d = 0; d < 3; d++) {
        const double margin = margin_of(c, m), most = c->cells[d] - 1;
        from[d] = (int)fmax(0, fmin(most, floor((m->low[d] - margin - c->origin[d]) / c->width[d])));
        to[d] = (int)fmax(0, fmin(most, floor((m->high[d] + margin - c->origin[d]) / c->width[d])));
    }
}

/* Sorts the members into cells: counts first, then places them from the end of each cell's range. */
static void sort(struct solid_compound *c) {
    const long cells = (long)c->cells[0] * c->cells[1] * c->cells[2];
    c->start = memory_new(MEMORY_SOLID, (size_t)cells + 1, sizeof *c->start);
    for (int pass = 0; pass < 2; pass++) {
        for (long m = c->members - 1; m >= 0; m--) {
            int from[3], to[3];
            cells_of(c, &c->member[m], from, to);
            for (int k = from[2]; k <= to[2]; k++)
                for (int j = from[1]; j <= to[1]; j++)
                    for (int i = from[0]; i <= to[0]; i++) {
                        const long at = ((long)k * c->cells[1] + j) * c->cells[0] + i;
                        if (pass == 0)
                            c->start[at]++;
                        else
                            c->item[--c->start[at]] = (int)m;
                    }
        }
        if (pass == 1) break;
        for (long at = 1; at <= cells; at++) c->start[at] += c->start[at - 1];
        c->item = memory_new(MEMORY_SOLID, (size_t)c->start[cells] + 1, sizeof *c->item);
    }
}

/* Cells of half the size that would give each member one, but no finer than the margin, or twice that of small members
 * where there are no others: else each of many small members would be in hundreds of cells. */
static void divide(struct solid_compound *c) {
    const double finest = c->small == c->members ? 2 * MARGIN_SMALL : MARGIN;
    double size[3], volume = 1;
    for (int d = 0; d < 3; d++) {
        double low = INFINITY, high = -INFINITY;
        for (long m = 0; m < c->members; m++) {
            low = fmin(low, c->member[m].low[d]);
            high = fmax(high, c->member[m].high[d]);
        }
        c->origin[d] = low - MARGIN * c->spacing;
        size[d] = high - low + 2 * MARGIN * c->spacing;
        volume *= size[d];
    }
    const double width = fmax(0.5 * cbrt(volume / (double)c->members), finest * c->spacing);
    for (int d = 0; d < 3; d++) {
        c->cells[d] = (int)fmin(CELLS_MAX, fmax(1, floor(size[d] / width)));
        c->width[d] = size[d] / c->cells[d];
    }
}

struct solid_compound *solid_compound_new(const struct solid_input *in, const struct solid_body *body) {
    if (!solid_shape_is_on_lattice(body)) return NULL;
    struct solid_compound *c = memory_new(MEMORY_SOLID, 1, sizeof *c);
    struct counting n = {c, in, 0, 0};
    const double tolerance = SOLID_ON_SURFACE * in->spacing;
    c->spacing = in->spacing;
    for (int d = 0; d < 3; d++) c->low[d] = INFINITY, c->high[d] = -INFINITY;
    visit_all(body, extend, &n);
    for (int d = 0; d < 3; d++)
        if (!(c->high[d] - c->low[d] < SITES_MAX * c->spacing && fabs(c->low[d]) < 1e3 * SITES_MAX * c->spacing))
            die_all(
                EXIT_CODE_SCENE,
                "solid.spacing = %g m: the body %s reaches from %g to %g m along %c; it may be %g spacings long, and "
                "begin at most %g spacings from 0",
                c->spacing, body->name, c->low[d], c->high[d], "xyz"[d], SITES_MAX, 1e3 * SITES_MAX);
    for (int d = 0; d < 3; d++) {
        const double below = -c->low[d], beyond = c->high[d] - in->length[d];
        const int spans = body->parts > 0 && below >= -tolerance && beyond >= -tolerance;
        c->is_wrapped[d] = in->periodic[d] && (below > tolerance || beyond > tolerance || spans);
    }
    c->cavities = solid_shape_cavities(body);
    visit_all(body, count, &n);
    ENSURE(n.members < INT_MAX, "a body of %ld shapes and images", n.members);
    c->member = memory_new(MEMORY_SOLID, (size_t)n.members + 1, sizeof *c->member);
    c->piece = memory_new(MEMORY_SOLID, (size_t)n.pieces + SOLID_PIECES_MAX, sizeof *c->piece);
    n.pieces = c->shapes = 0;
    visit_all(body, add, &n);
    if (c->members == 0) return c;
    divide(c);
    sort(c);
    return c;
}

void solid_compound_free(struct solid_compound *c) {
    if (!c) return;
    MEMORY_FREE(c->member, c->piece, c->start, c->item, c);
}

const int *solid_compound_near(const struct solid_compound *c, const double x[3], int *n) {
    long at = 0;
    *n = 0;
    for (int d = 2; d >= 0 && c->members > 0; d--) {
        const double cell = (x[d] - c->origin[d]) / c->width[d];
        if (!(cell >= 0 && cell < c->cells[d])) return NULL;
        at = at * c->cells[d] + (int)cell;
    }
    if (c->members == 0) return NULL;
    *n = (int)(c->start[at + 1] - c->start[at]);
    return c->item + c->start[at];
}

int solid_compound_piece(const struct solid_compound *c, const struct solid_compound_member *m, int k,
                         const double x[3], struct solid_piece *piece) {
    if (k < m->pieces) {
        *piece = c->piece[m->first + k];
        return 1;
    }
    if (k > m->pieces || m->is_hole || !(c->cavities.period > 0)) return 0;
    double at[3];
    for (int d = 0; d < 3; d++) at[d] = x[d] - m->shift[d];
    *piece = solid_shape_cavity(&c->cavities, at);
    for (int d = 0; d < 3; d++) piece->centre[d] += m->shift[d];
    return 1;
}

static int is_within(const struct solid_compound *c, const struct solid_compound_member *m, const double x[3]) {
    const double margin = margin_of(c, m);
    for (int d = 0; d < 3; d++)
        if (x[d] < m->low[d] - margin || x[d] > m->high[d] + margin) return 0;
    return 1;
}

/* Depth below a shape's pieces and its cavity, the least of them; of a hole, whose pieces are turned, the greatest. */
static double depth_of(struct solid_compound *c, const struct solid_compound_member *m, const double x[3]) {
    double depth = m->is_hole ? -INFINITY : INFINITY;
    struct solid_piece cavity;
    c->tested++;
    for (int k = 0; k < m->pieces; k++) {
        const double below = solid_shape_piece_depth(&c->piece[m->first + k], x, c->spacing);
        depth = m->is_hole ? fmax(depth, below) : fmin(depth, below);
    }
    if (c->cavities.period > 0 && solid_compound_piece(c, m, m->pieces, x, &cavity))
        depth = fmin(depth, solid_shape_piece_depth(&cavity, x, c->spacing));
    return depth;
}

double solid_compound_depth(struct solid_compound *c, const double x[3]) {
    int n;
    const int *near = solid_compound_near(c, x, &n);
    double in = -INFINITY, out = INFINITY;
    for (int k = 0; k < n; k++) {
        const struct solid_compound_member *m = &c->member[near[k]];
        if (!is_within(c, m, x)) continue;
        if (m->is_hole)
            out = fmin(out, depth_of(c, m, x));
        else
            in = fmax(in, depth_of(c, m, x));
    }
    return fmin(in, out);
}

double solid_compound_unseen(const struct solid_compound *c) {
    return (c->small > 0 ? MARGIN_SMALL : MARGIN) * c->spacing;
}

int solid_compound_shape(struct solid_compound *c, const double x[3]) {
    int n, shape = -1;
    const int *near = solid_compound_near(c, x, &n);
    double deepest = -SOLID_ON_SURFACE * c->spacing;
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < n; k++) {
            const struct solid_compound_member *m = &c->member[near[k]];
            if (m->is_hole || !is_within(c, m, x)) continue;
            const double depth = depth_of(c, m, x);
            if (pass == 0)
                deepest = fmax(deepest, depth);
            else if (depth >= deepest - SOLID_ON_SURFACE * c->spacing && (shape < 0 || m->shape < shape))
                shape = m->shape;
        }
    return shape;
}
