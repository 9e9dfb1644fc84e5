# The misses of a case: each row of summary.csv that misses its tolerance stands in the case's misses.csv, with the
# range that its value may not leave, whether its reason was tested (yes, part or no), and the reason.
# usage: awk -f tools/csv.awk -f tools/misses.awk [-v page=1] [-v strict=1] CASE/misses.csv CASE/results/summary.csv
#   page: lists the misses for docs/accuracy.md; else prints what has become worse, and leaves with 1 if something has
#   strict: prints as well which row has no reason, and which line of misses.csv is no miss
# Without a range the row has no number, and may not get a wrong one.
function held(x, low, high) {
    if (low == "") return x == ""
    return x ~ /^[-+]?[.0-9]/ && x + 0 >= low + 0 && (high == "inf" || x + 0 <= high + 0)
}
BEGIN { word["yes"] = "tested"; word["part"] = "tested in part"; word["no"] = "not tested" }
FNR == 1 { file++; next }
file == 1 {
    csv($0, cell)
    low[cell[1]] = cell[2]; high[cell[1]] = cell[3]; tested[cell[1]] = cell[4]; reason[cell[1]] = cell[5]
    if (cell[4] !~ /^(yes|part|no)$/ || cell[5] == "") {
        bad = 1
        print FILENAME ":" FNR ": tested must be yes, part or no, with a reason"
    }
    next
}
!/,no$/ { next }
{
    csv($0, cell)
    quantity = cell[1]; ours = cell[3]
    seen[quantity] = 1
    if (page) {
        printf "* missed: %s: %s%s, reference %s, asked %s", quantity, ours == "" ? "none" : ours,
            cell[2] == "1" || cell[2] == "" ? "" : " " cell[2], cell[4], cell[6]
        if (low[quantity] != "") printf "; held within %s to %s", low[quantity], high[quantity]
        printf ". Reason (%s): %s\n", word[tested[quantity]], reason[quantity]
    } else if (!(quantity in reason)) {
        if (!strict) next
        bad = 1
        print FILENAME ":" FNR ": misses, but misses.csv has no reason and no range for it: " quantity
    } else if (!held(ours, low[quantity], high[quantity])) {
        bad = 1
        print FILENAME ":" FNR ": the miss has become worse: " quantity ": " ours " is outside " low[quantity] " to " \
            high[quantity]
    }
}
END {
    for (quantity in reason)
        if (strict && !(quantity in seen)) {
            bad = 1
            print "misses.csv: no row misses this: " quantity
        }
    exit page ? 0 : bad
}
