/* Writes what a calibration has measured: calibration.csv, a table, and a sentence on what to enter. */
#include "program/calibrate/report.h"
#include "base/die.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void calibrate_report_add(struct calibrate_rows *rows, struct calibrate_row row) {
    struct calibrate_row *more = realloc(rows->row, (size_t)(rows->n + 1) * sizeof *more);
    if (!more) die(EXIT_CODE_FILE, "no memory left for the calibration's table");
    rows->row = more;
    rows->row[rows->n++] = row;
}

/* [100], 15 deg, [110]; nothing where there is no direction. */
static const char *direction_of(double degrees, char text[32]) {
    text[0] = '\0';
    if (degrees == 0)
        strcpy(text, "[100]");
    else if (degrees == 45)
        strcpy(text, "[110]");
    else if (isfinite(degrees))
        snprintf(text, 32, "%g deg", degrees);
    return text;
}

static void print_row(FILE *to, const struct calibrate_row *r) {
    char text[32];
    if (isnan(r->value))
        fprintf(to, "  %-28s %-8s not measured", r->quantity, direction_of(r->degrees, text));
    else
        fprintf(to, "  %-28s %-8s %8.4f %-16s %12.6g %s", r->quantity, direction_of(r->degrees, text), r->value,
                r->over, r->measured, r->unit);
    fputc('\n', to);
}

void calibrate_report_print(const struct scene *s, const struct calibrate_row *row) {
    printf("%s:", s->solid->material[row->material].name);
    print_row(stdout, row);
    fflush(stdout);
}

void calibrate_report_csv(const char *out, const struct scene *s, const struct calibrate_rows *rows) {
    char path[FOLDER_PATH], text[32];
    struct atomic_write a;
    atomic_write_begin(&a, folder_path(path, out, "calibration.csv"));
    fputs("material,quantity,direction,value,over,measured,unit\n", a.file);
    for (int i = 0; i < rows->n; i++) {
        const struct calibrate_row *r = &rows->row[i];
        fprintf(a.file, "%s,%s,%s,%.10g,%s,%.10g,%s\n", s->solid->material[r->material].name, r->quantity,
                direction_of(r->degrees, text), r->value, r->over, r->measured, r->unit);
    }
    atomic_write_end(&a);
}

/* The least and the largest value of a quantity over its directions; NaN: not measured. */
static void range_of(const struct calibrate_rows *rows, int material, const char *quantity, double range[2]) {
    range[0] = range[1] = NAN;
    for (int i = 0; i < rows->n; i++) {
        const struct calibrate_row *r = &rows->row[i];
        if (r->material != material || strcmp(r->quantity, quantity) != 0) continue;
        range[0] = fmin(range[0], r->value);
        range[1] = fmax(range[1], r->value);
    }
}

static void print_advice(FILE *to, const struct scene *s, const struct calibrate_rows *rows, int m) {
    const struct scene_material *k = &s->solid->material[m];
    double running[2], creeping[2], bar[2];
    range_of(rows, m, "running_crack", running);
    range_of(rows, m, "creeping_crack", creeping);
    range_of(rows, m, "bar_strength", bar);
    fprintf(to, "%s: for a rock of toughness G enter as fracture_energy", k->name);
    if (isfinite(running[0]))
        fprintf(to, " %.3g G if its cracks run (in place of %g J/m2: %.4g; by direction %.4g to %.4g)",
                2 / (running[0] + running[1]), k->fracture_energy, 2 * k->fracture_energy / (running[0] + running[1]),
                k->fracture_energy / running[1], k->fracture_energy / running[0]);
    if (isfinite(creeping[0]))
        fprintf(to, "%s %.3g G if they creep (%.4g J/m2)", isfinite(running[0]) ? "," : "",
                2 / (creeping[0] + creeping[1]), 2 * k->fracture_energy / (creeping[0] + creeping[1]));
    if (!isfinite(running[0]) && !isfinite(creeping[0])) fputs(" G itself: no crack was measured", to);
    if (isfinite(bar[0]) && k->breakage == SCENE_BILINEAR)
        fprintf(to, "; for a tensile strength S enter %.3g S (in place of %g Pa: %.4g)", 1 / bar[0],
                k->tensile_strength, k->tensile_strength / bar[0]);
    fputs(".\n", to);
    if (k->breakage == SCENE_BILINEAR)
        fputs("Both change E G0/sigma_t2, on which the numbers depend: calibrate again with what you enter.\n", to);
}

void calibrate_report_page(FILE *to, const struct scene *s, const struct calibrate_rows *rows) {
    fprintf(to, "%s\n", s->title);
    for (int m = 0; m < s->solid->materials; m++) {
        int n = 0;
        for (int i = 0; i < rows->n; i++) {
            if (rows->row[i].material != m) continue;
            if (n++ == 0) fprintf(to, "\n%s\n", s->solid->material[m].name);
            print_row(to, &rows->row[i]);
        }
        if (n > 0) print_advice(to, s, rows, m);
    }
}
