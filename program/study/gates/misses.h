/* Known misses of a case, and how far each may go: misses.csv beside the file of gates, with the columns quantity, low,
 * high, tested and reason (docs/study.md#gates). */
#pragma once

/* Whether a row that misses its tolerance stays in the range that the table gives it. line: of summary.csv; table: the
 * text of misses.csv. A row that the table does not have is not held. */
int study_gates_misses_hold(const char *table, const char *line);
