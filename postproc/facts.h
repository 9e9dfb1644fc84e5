/* The numbers of a report: quantity, unit, value, in the order in which they were added. */
#pragma once

enum { POSTPROC_FACTS = 256 };
struct postproc_fact {
    char quantity[96], unit[16], text[160]; /* text: as printed in the report; a word if value is NAN */
    double value;
};
struct postproc_facts {
    int n;
    struct postproc_fact fact[POSTPROC_FACTS];
};

/* A quantity's name made by a printf format: NAMED("%s, mean", ring). */
struct postproc_facts_name {
    char text[96];
};
struct postproc_facts_name postproc_facts_name(const char *format, ...) __attribute__((format(printf, 1, 2)));
#define NAMED(...) postproc_facts_name(__VA_ARGS__).text
/* A number that is NAN is left out. */
void postproc_facts_number(struct postproc_facts *f, const char *quantity, const char *unit, double value);
void postproc_facts_text(struct postproc_facts *f, const char *quantity, const char *text);
const struct postproc_fact *postproc_facts_find(const struct postproc_facts *f, const char *quantity);
/* quantity,unit,value. Returns 0, or -1 (errno). */
int postproc_facts_write(const struct postproc_facts *f, const char *path);
/* The facts from number first on. */
int postproc_facts_write_from(const struct postproc_facts *f, int first, const char *path);
