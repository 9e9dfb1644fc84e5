/* Results of scenes that are solved at once. */
#pragma once

/* Prints on rank 0. Not collective. */
void solution_say(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* A line of a table `quantity,unit,value`, which frana study and frana post read. */
struct solution_fact {
    const char *quantity, *unit;
    double value;
};
/* Writes folder/solution.csv. Rank 0 writes. Collective. */
void solution_write(int n, const struct solution_fact *fact, const char *folder);
