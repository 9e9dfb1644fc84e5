/* Whether somebody is looking. Not collective; asked by the rank that writes. */
#pragma once

/* Columns of the terminal that standard output ends on, 0 when it ends on none. */
int log_terminal_columns(void);
