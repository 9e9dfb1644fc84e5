/* Width of the terminal that standard output ends on. Not collective; called by the rank that writes. */
#pragma once

/* Columns of that terminal; 0 if standard output ends on none. */
int log_terminal_columns(void);
