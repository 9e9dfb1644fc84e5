# Counts the tolerances of cases by what their reference is. The first line of cases/kinds.csv whose patterns match
# case, source and quantity says the kind.
# usage: awk -f tools/csv.awk -f tools/kinds.awk [-v check=1] cases/kinds.csv SUMMARY...
#   prints for each kind: kind, tolerances, met; with check instead the rows without a kind and the lines without a row
FNR == 1 { file++; name = FILENAME; sub(/^cases\//, "", name); sub(/\/results\/.*/, "", name); next }
file == 1 {
    csv($0, cell)
    rules++
    for (k = 1; k <= 4; k++) rule[rules, k] = cell[k]
    next
}
{
    csv($0, cell)
    for (r = 1; r <= rules; r++)
        if (name ~ rule[r, 1] && cell[5] ~ rule[r, 2] && cell[1] ~ rule[r, 3]) break
    used[r]++
    if (r > rules) { if (check) print FILENAME ":" FNR ": cases/kinds.csv has no kind for it: " cell[1]; bad = 1; next }
    all[rule[r, 4]]++
    if (cell[7] == "yes") met[rule[r, 4]]++
}
END {
    for (r = 1; r <= rules; r++)
        if (check && !(r in used)) { bad = 1; print "cases/kinds.csv:" r + 1 ": no row is of this kind" }
    n = split("independent program invariant own stability", kind, " ")
    for (k = 1; k <= n && !check; k++) print kind[k], all[kind[k]] + 0, met[kind[k]] + 0
    exit check ? bad : 0
}
