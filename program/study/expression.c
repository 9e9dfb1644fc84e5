/* Evaluates arithmetic in texts by recursive descent. */
#include "program/study/expression.h"
#include "base/arena.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct parser {
    const char *at;
    study_expression_lookup *lookup;
    const void *with;
    const char *why;
};

static double sum(struct parser *p);

static double wrong(struct parser *p, const char *why) {
    if (!p->why) p->why = why;
    return NAN;
}

/* Skips blanks, and the character if it is there. */
static int takes(struct parser *p, char c) {
    while (isspace((unsigned char)*p->at)) p->at++;
    if (*p->at != c) return 0;
    p->at++;
    return 1;
}

static double reference(struct parser *p) {
    const size_t length = strcspn(p->at, "]");
    if (!p->at[length]) return wrong(p, "a ] is missing");
    const double value = p->lookup(arena_text("%.*s", (int)length, p->at), p->with);
    p->at += length + 1;
    return value;
}

static double atan_of(double x) { return atan(x); }
static double magnitude(double x) { return fabs(x); }

static double call_one(struct parser *p, double (*f)(double)) {
    if (!takes(p, '(')) return wrong(p, "a ( is missing");
    const double x = f(sum(p));
    return takes(p, ')') ? x : wrong(p, "a ) is missing");
}

/* Of two numbers or more. */
static double call_many(struct parser *p, double (*f)(double, double)) {
    if (!takes(p, '(')) return wrong(p, "a ( is missing");
    double x = sum(p);
    int n = 1;
    for (; takes(p, ','); n++) x = f(x, sum(p));
    if (n == 1) return wrong(p, "a second number is missing");
    return takes(p, ')') ? x : wrong(p, "a ) is missing");
}

static double word(struct parser *p) {
    static const struct {
        const char *name;
        double (*one)(double), (*many)(double, double);
    } known[] = {{"sqrt", sqrt, NULL},     {"log", log, NULL},  {"exp", exp, NULL},
                 {"abs", magnitude, NULL}, {"sin", sin, NULL},  {"cos", cos, NULL},
                 {"atan", atan_of, NULL},  {"min", NULL, fmin}, {"max", NULL, fmax}};
    const char *start = p->at;
    while (isalpha((unsigned char)*p->at)) p->at++;
    const size_t length = (size_t)(p->at - start);
    if (length == 2 && !strncmp(start, "pi", 2)) return acos(-1);
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (strlen(known[k].name) == length && !strncmp(known[k].name, start, length))
            return known[k].one ? call_one(p, known[k].one) : call_many(p, known[k].many);
    return wrong(p, "not a number, a function or [a reference]");
}

static double atom(struct parser *p) {
    if (takes(p, '(')) {
        const double x = sum(p);
        return takes(p, ')') ? x : wrong(p, "a ) is missing");
    }
    if (takes(p, '[')) return reference(p);
    if (!isdigit((unsigned char)*p->at) && *p->at != '.') return word(p);
    char *end;
    const double x = strtod(p->at, &end);
    p->at = end;
    return x;
}

static double power(struct parser *p);

static double signed_power(struct parser *p) { return takes(p, '-') ? -signed_power(p) : power(p); }

static double power(struct parser *p) {
    const double base = atom(p);
    return takes(p, '^') ? pow(base, signed_power(p)) : base;
}

static double product(struct parser *p) {
    double x = signed_power(p);
    for (;;)
        if (takes(p, '*'))
            x *= signed_power(p);
        else if (takes(p, '/'))
            x /= signed_power(p);
        else
            return x;
}

static double sum(struct parser *p) {
    double x = product(p);
    for (;;)
        if (takes(p, '+'))
            x += product(p);
        else if (takes(p, '-'))
            x -= product(p);
        else
            return x;
}

double study_expression_value(const char *text, study_expression_lookup *lookup, const void *with, const char **why) {
    struct parser p = {text, lookup, with, NULL};
    const double x = sum(&p);
    takes(&p, ' ');
    if (*p.at) wrong(&p, "something follows the arithmetic");
    if (p.why) *why = p.why;
    return p.why ? NAN : x;
}
