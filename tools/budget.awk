# What a run of so many seconds gives, and what an error of 1 % costs, from tables of studies: a row for each quantity.
# usage: awk -f tools/csv.awk -f tools/budget.awk STUDY.csv ...
# A run that is the reference (error 0) and errors that the reference does not resolve are left out.
BEGIN {
    seconds[1] = 1; seconds[2] = 10; seconds[3] = 60; seconds[4] = 600; budgets = 4
    print "\n## What so many seconds give, and what 1 % costs\n"
    print "The smallest error of all runs of the studies of [cost](../cases/verification/cost) that take no longer: of"
    print "a small block that a flow passes and breaks. Wall times are of the steps on the tables' machine. Errors"
    print "that the reference does not resolve are left out: more seconds buy no certainty there.\n"
    print "| study: quantity | 1 s | 10 s | a minute | ten minutes | 1 % costs |\n|---|---|---|---|---|---|"
}
function percent(e) { return sprintf("%.2g %%", 100 * e) }
function flush(  q, b, line, cell, was) {
    for (q = 1; q <= quantities; q++) {
        line = ""; was = ""
        for (b = 1; b <= budgets; b++) {
            cell = (q, b) in best ? percent(best[q, b]) " (" who[q, b] ")" : "–"
            line = line " | " (cell == was && cell != "–" ? "the same" : cell)
            was = cell
        }
        if ((q, budgets) in best)
            print "| " title ": " name[q] line " | " \
                (q in cost ? sprintf("%.2g s (%s)", cost[q], cheapest[q]) : "more") " |"
    }
    split("", best); split("", who); split("", cost); split("", cheapest); split("", index_of); split("", at)
    quantities = 0
}
FNR == 1 { flush(); title = substr($0, 3); next }
/^#/ { next }
/^method,level/ { n = csv($0, cell); for (k = 1; k <= n; k++) at[cell[k]] = k; next }
{
    csv($0, cell)
    e = cell[at["relative_error"]]; t = cell[at["wall_median_s"]]; u = cell[at["uncertainty"]] + 0
    if (e == "" || t == "" || e + 0 <= 0 || cell[at["error"]] + 0 <= u) next
    q = cell[at["quantity"]]
    if (!(q in index_of)) { index_of[q] = ++quantities; name[quantities] = q }
    q = index_of[q]; label = cell[1] ", " cell[2]
    for (b = 1; b <= budgets; b++)
        if (t + 0 <= seconds[b] && (!((q, b) in best) || e + 0 < best[q, b])) { best[q, b] = e + 0; who[q, b] = label }
    if (e <= 0.01 && (!(q in cost) || t + 0 < cost[q])) { cost[q] = t + 0; cheapest[q] = label }
}
END { flush() }
