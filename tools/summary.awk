# Prints a summary.csv of frana post as a table: numbers to five digits, whole numbers as they are.
# Its rows are quantity,unit,value; a field that contains a comma is in quotes.
# usage: awk [-v only='QUANTITY|QUANTITY|...'] -f summary.awk summary.csv       only: these rows, without it all
BEGIN {
    chosen = split(only, name, "|")
    for (i = 1; i <= chosen; i++) is_chosen[name[i]] = 1
}
function field(   f) {
    if (substr($0, 1, 1) == "\"") {
        f = substr($0, 2)
        $0 = substr(f, index(f, "\"") + 2)
        return substr(f, 1, index(f, "\"") - 1)
    }
    f = index($0, ",") ? substr($0, 1, index($0, ",") - 1) : $0
    $0 = index($0, ",") ? substr($0, index($0, ",") + 1) : ""
    return f
}
/^#/ || NR == 1 { next }
{
    q = field(); u = field(); v = field()
    if (chosen && !(q in is_chosen)) next
    if (v ~ /^[-+0-9.eE]+$/ && v !~ /^[-+]?[0-9]+$/) v = sprintf("%.5g", v)
    printf "  %-52s %16s%s\n", q, v, u == "" || u == "1" ? "" : "  " u
}
