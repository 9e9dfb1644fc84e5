/* Partial areas: the part of a square cell inside the horizon's disc, in closed form.  (000: eq. 22) */
#include "solid/law/weight_plane.h"

#include <math.h>

/* Twice the area under the arc from 0 to the point (x, y) on it; from the angle, which is accurate where the arc is
 * steep. */
static double under_arc(double x, double y, double r) { return x * y + r * r * atan2(x, y); }

/* The other coordinate of a point of the circle; 0 outside it. */
static double on_circle(double x, double r) { return x < r ? sqrt((r - x) * (r + x)) : 0; }

/* Area of the disc inside the rectangle [x0, x1] x [y0, y1] in the first quadrant:
 *
 *      y1 +-----.--------+
 *         |      \       |     full height up to the abscissa where the circle leaves through the top,
 *         | full  \      |     under the arc from there to where it leaves through the bottom
 *      y0 +--------\-----+
 *        x0      a  b    x1 */
static double area_in_quadrant(double x0, double x1, double y0, double y1, double r) {
    const double top = on_circle(y1, r), bottom = on_circle(y0, r);
    if (bottom <= x0) return 0;
    if (top >= x1) return (x1 - x0) * (y1 - y0);
    const double a = top > x0 ? top : x0, ya = top > x0 ? y1 : on_circle(x0, r);
    const double b = bottom < x1 ? bottom : x1, yb = bottom < x1 ? y0 : on_circle(x1, r);
    const double arc = 0.5 * (under_arc(b, yb, r) - under_arc(a, ya, r)) - y0 * (b - a);
    return (a - x0) * (y1 - y0) + fmax(arc, 0);
}

/* The parts of [x - half, x + half] on both sides of 0, as intervals of |x|; x >= 0. Returns how many. */
static int fold(double x, double half, double low[2], double high[2]) {
    low[0] = fmax(x - half, 0);
    high[0] = x + half;
    low[1] = 0;
    high[1] = half - x;
    return high[1] > 0 ? 2 : 1;
}

double solid_weight_plane_fraction(const double xi[2], double side, double radius) {
    const double p = fabs(xi[0]), q = fabs(xi[1]), half = 0.5 * side;
    const double small = p < q ? p : q, large = p < q ? q : p;
    double x0[2], x1[2], y0[2], y1[2], area = 0;
    const int columns = fold(small, half, x0, x1), rows = fold(large, half, y0, y1);
    if (x1[0] * x1[0] + y1[0] * y1[0] <= radius * radius) return 1;
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++) area += area_in_quadrant(x0[i], x1[i], y0[j], y1[j], radius);
    return fmin(area / (side * side), 1);
}
