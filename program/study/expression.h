/* Arithmetic in texts. */
#pragma once

/* The number that the text between [ and ] stands for. */
typedef double study_expression_lookup(const char *reference, const void *with);

/* Numbers, pi, + - * / ^, parentheses, sqrt log exp abs sin cos atan of one number, min max of two or more,
 * [references]. *why: what is wrong, else unchanged; the value is then NAN. */
double study_expression_value(const char *text, study_expression_lookup *lookup, const void *with, const char **why);
