/* Writes the report as Markdown and as HTML. */
#include "postproc/report.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"

#include <stdio.h>
#include <stdlib.h>

struct postproc_report {
    FILE *md, *html;
    char folder[FOLDER_PATH];
    int missing; /* 1: an image could not be read */
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
    FILE *md = atomic_write_open(folder_path(path, folder, "report.md"));
    FILE *html = md ? atomic_write_open(folder_path(path, folder, "report.html")) : NULL;
    if (!html) {
        if (md) atomic_write_close(md, folder_path(path, folder, "report.md"), 1);
        return NULL;
    }
    struct postproc_report *r = calloc(1, sizeof *r);
    *r = (struct postproc_report){.md = md, .html = html};
    snprintf(r->folder, sizeof r->folder, "%s", folder);
    fputs("# ", md);
    put_md(md, title);
    fputc('\n', md);
    fputs("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>", html);
    put_html(html, title);
    fputs("</title>\n<style>body{font:16px/1.5 sans-serif;color:#23282e;max-width:60em;margin:2em "
          "auto;padding:0 1em}"
          "table{border-collapse:collapse}th,td{text-align:left;padding:.15em 1.2em .15em "
          "0;border-bottom:1px solid #e4e7ea}"
          "figure{margin:2em "
          "0}figcaption{color:#5a6068}img{max-width:100%}input{width:100%}h2{margin-top:2em}</style></head><body>\n",
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

/* The bytes of a file in base 64. Returns 0, or -1 if it cannot be read. */
static int put_base64(FILE *f, const char *path) {
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    FILE *from = fopen(path, "rb");
    if (!from) return -1;
    unsigned char in[3];
    for (size_t n; (n = fread(in, 1, 3, from)) > 0;) {
        for (size_t i = n; i < 3; i++) in[i] = 0;
        const char out[4] = {digit[in[0] >> 2], digit[(in[0] & 3) << 4 | in[1] >> 4],
                             n > 1 ? digit[(in[1] & 15) << 2 | in[2] >> 6] : '=', n > 2 ? digit[in[2] & 63] : '='};
        fwrite(out, 1, 4, f);
    }
    const int bad = ferror(from);
    fclose(from);
    return bad ? -1 : 0;
}

/* An image with its bytes, so that the page needs no other file. */
static void put_image(struct postproc_report *r, const char *path, const char *title, const char *more) {
    char file[FOLDER_PATH];
    fprintf(r->html, "<img %s alt=\"", more);
    put_html(r->html, title);
    fputs("\" src=\"data:image/png;base64,", r->html);
    if (put_base64(r->html, folder_path(file, r->folder, path))) r->missing = 1;
    fputs("\">", r->html);
}

void postproc_report_image(struct postproc_report *r, const char *path, const char *title) {
    fprintf(r->md, "\n![%s](%s)\n", title, path);
    fputs("<figure>", r->html);
    put_image(r, path, title, "");
    fputs("<figcaption>", r->html);
    put_html(r->html, title);
    fputs("</figcaption></figure>\n", r->html);
}

void postproc_report_film(struct postproc_report *r, int n, const char *const *path, const char *title) {
    if (n < 1) return;
    fprintf(r->md, "\nFilm: %s to %s\n", path[0], path[n - 1]);
    fputs("<figure class=\"film\">", r->html);
    for (int k = 0; k < n; k++) put_image(r, path[k], title, k ? "hidden" : "");
    fprintf(r->html,
            "<input type=\"range\" min=\"0\" max=\"%d\" value=\"0\" aria-label=\"picture\" "
            "oninput=\"this.parentNode.querySelectorAll('img').forEach((i,k)=>i.hidden=k!=this.value)\"><figcaption>",
            n - 1);
    put_html(r->html, title);
    fputs("</figcaption></figure>\n", r->html);
}

int postproc_report_end(struct postproc_report *r) {
    fputs("</body></html>\n", r->html);
    char path[FOLDER_PATH];
    int fault = atomic_write_close(r->md, folder_path(path, r->folder, "report.md"), r->missing);
    fault |= atomic_write_close(r->html, folder_path(path, r->folder, "report.html"), r->missing);
    free(r);
    return fault;
}
