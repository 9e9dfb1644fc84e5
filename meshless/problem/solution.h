/* Results of scenes that are solved at once. */
#pragma once

/* A line of a table `quantity,unit,value`, which frana study and frana post read. */
struct meshless_solution_quantity {
    const char *quantity, *unit;
    double value;
};
/* Writes folder/solution.csv. Rank 0 writes. Collective. */
void meshless_solution_write(int n, const struct meshless_solution_quantity *fact, const char *folder);
