/* Numbers and names in texts. */
#pragma once

/* The number in a text, without blanks around it; NAN if it is not a number. text may be NULL. */
double study_text_number(const char *text);
/* A text turned into a part of a file name: letters, digits, '.', '_' and '-' are kept, all else becomes '-';
 * Never empty. */
char *study_text_slug(const char *text);
/* The next cell of a CSV line, in place, without quotes; *line: what follows it, NULL at the end. NULL: no cell is
 * left. */
char *study_text_cell(char **line);
