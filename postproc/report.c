/* Writes the report as Markdown and as HTML. */
#include "postproc/report.h"
#include "files/folder.h"

#include <stdio.h>
#include <stdlib.h>

struct postproc_report {
    FILE *md, *html;
};

/* Escapes a bar, which would end a table's cell, and an angle bracket, which would begin HTML. */
static void put_md(FILE *f, const char *text) {
    for (; *text; text++) {
        if (*text == '|' || *text == '<') fputc('\\', f);
        fputc(*text == '\n' ? ' ' : *text, f);
    }
}

static void put_html(FILE *f, const char *text) {
    for (; *text; text++) switch (*text) {
        case '<':
            fputs("&lt;", f);
            break;
        case '>':
            fputs("&gt;", f);
            break;
        case '&':
            fputs("&amp;", f);
            break;
        case '"':
            fputs("&quot;", f);
            break;
        default:
            fputc(*text, f);
        }
}

static void put_element(FILE *f, const char *element, const char *text) {
    fprintf(f, "<%s>", element);
    put_html(f, text);
    fprintf(f, "</%s>\n", element);
}

struct postproc_report *postproc_report_begin(const char *folder, const char *title) {
    char path[FOLDER_PATH];
    FILE *md = fopen(folder_path(path, folder, "report.md"), "w");
    FILE *html = md ? fopen(folder_path(path, folder, "report.html"), "w") : NULL;
    if (!html) {
        if (md) fclose(md);
        return NULL;
    }
    struct postproc_report *r = calloc(1, sizeof *r);
    *r = (struct postproc_report){md, html};
    fputs("# ", md);
    put_md(md, title);
    fputc('\n', md);
    fputs("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>", html);
    put_html(html, title);
    fputs("</title>\n<style>body{font:16px/1.5 sans-serif;color:#23282e;max-width:60em;margin:2em "
          "auto;padding:0 1em}"
          "table{border-collapse:collapse}th,td{text-align:left;padding:.15em 1.2em .15em "
          "0;border-bottom:1px solid #e4e7ea}"
          "img{max-width:100%}h2{margin-top:2em}</style></head><body>\n",
          html);
    put_element(html, "h1", title);
    return r;
}

void postproc_report_heading(struct postproc_report *r, const char *text) {
    fprintf(r->md, "\n## %s\n", text);
    put_element(r->html, "h2", text);
}

void postproc_report_text(struct postproc_report *r, const char *text) {
    fprintf(r->md, "\n%s\n", text);
    put_element(r->html, "p", text);
}

void postproc_report_table(struct postproc_report *r, int n, int m, const char *const *cell) {
    fputc('\n', r->md);
    fputs("<table>\n", r->html);
    for (int i = 0; i < n; i++) {
        fputs("<tr>", r->html);
        for (int j = 0; j < m; j++) {
            fputs(j ? " | " : "| ", r->md);
            put_md(r->md, cell[i * m + j]);
            put_element(r->html, i ? "td" : "th", cell[i * m + j]);
        }
        fputs(" |\n", r->md);
        fputs("</tr>\n", r->html);
        for (int j = 0; i == 0 && j < m; j++) fputs(j == m - 1 ? "|---|\n" : "|---", r->md);
    }
    fputs("</table>\n", r->html);
}

void postproc_report_facts(struct postproc_report *r, const struct postproc_facts *f, int first, int last) {
    if (last <= first) return;
    const char *cell[3 * (POSTPROC_FACTS + 1)] = {"quantity", "value", "unit"};
    int rows = 1;
    for (int i = first; i < last; i++, rows++) {
        cell[3 * rows] = f->fact[i].quantity;
        cell[3 * rows + 1] = f->fact[i].text;
        cell[3 * rows + 2] = f->fact[i].unit;
    }
    postproc_report_table(r, rows, 3, cell);
}

void postproc_report_image(struct postproc_report *r, const char *path, const char *title) {
    fprintf(r->md, "\n![%s](%s)\n", title, path);
    fprintf(r->html, "<p><img src=\"%s\" alt=\"", path);
    put_html(r->html, title);
    fputs("\"></p>\n", r->html);
}

int postproc_report_end(struct postproc_report *r) {
    fputs("</body></html>\n", r->html);
    int bad = ferror(r->md) || ferror(r->html);
    if (fclose(r->md)) bad = 1;
    if (fclose(r->html)) bad = 1;
    free(r);
    return bad ? -1 : 0;
}
