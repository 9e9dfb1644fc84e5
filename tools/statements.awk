# Copies a page, and writes its tables of statements anew. A table stands between the lines
#   <!-- statements: TABLE FOLDER --> and <!-- end -->
# and is made of TABLE, a CSV file beside the page. Files in its cells are those of cases/FOLDER.
# usage: awk -v page=PAGE -f tools/csv.awk -f tools/statements.awk PAGE
#
# Columns of TABLE: key, low and high are not shown; all others are, in order, and "asked" is made of low and high. In
# any cell {EXPRESSION %FORMAT} stands for a number judged by low and high, {~EXPRESSION %FORMAT} for one that is not.
# LOW:HIGH after the format is the range of that number alone. It has numbers, + - * /, ( ), abs( ), sqrt( ), and
#   [FILE|ROW|COLUMN]   a cell of a CSV file in results/ (or FOLDER/FILE: in the results of cases/FOLDER). ROW is the
#                       first cells of a row, joined by "^", or "last", or a number: the first row whose first cell is
#                       that or more.
#   [FILE.yaml|KEY]     the first value of KEY in a scene
# @ stands for the row's key. A cell is marked by a tick if all of its judged numbers are in the range, by a cross if
# none is, else by "in part". A file, row or column that does not exist gives a dash, and no mark.
function load(path,  line, n, cell, i) {
    if (path in rows) return rows[path]
    rows[path] = -1
    while ((getline line < path) > 0) {
        if (line ~ /^#/) continue
        n = csv(line, cell)
        rows[path]++
        for (i = 1; i <= n; i++) {
            if (rows[path] == 0) column[path, cell[i]] = i
            at[path, rows[path], i] = cell[i]
        }
    }
    close(path)
    return rows[path]
}
function scene(path, key,  line) {
    while ((getline line < path) > 0)
        if (match(line, "(^|[ {,])" key ": *")) {
            line = substr(line, RSTART + RLENGTH)
            if (!match(line, /^\[[^]]*\]/)) match(line, /^[^,}#]*[^,}# ]/)
            line = substr(line, 1, RLENGTH)
            close(path)
            return line
        }
    close(path)
    missing = 1
}
function has(path, r, row,  part, n, i) {
    n = split(row, part, "^")
    for (i = 1; i <= n; i++) if (at[path, r, i] != part[i]) return 0
    return 1
}
function reference(text,  part, path, r, n, c) {
    split(text, part, "|")
    path = "cases/" (part[1] ~ /\// ? part[1] : folder "/" part[1])
    if (path ~ /yaml$/) return scene(path, part[2])
    sub(/[^\/]*$/, "results/&", path)
    n = load(path)
    c = column[path, part[3]]
    for (r = part[2] == "last" ? n : 1; r <= n; r++)
        if (part[2] == "last" || (part[2] ~ /^[0-9]+$/ ? at[path, r, 1] ~ /^[0-9]/ && at[path, r, 1] + 0 >= part[2] \
            : has(path, r, part[2]))) break
    if (n < 1 || r > n || !c || at[path, r, c] == "") { missing = 1; return 0 }
    return at[path, r, c]
}
function factor(  x) {
    sub(/^ */, "", rest)
    if (sub(/^-/, "", rest)) return -factor()
    if (sub(/^abs\(/, "", rest)) { x = sum(); sub(/^ *\)/, "", rest); return x < 0 ? -x : x }
    if (sub(/^sqrt\(/, "", rest)) { x = sum(); sub(/^ *\)/, "", rest); return sqrt(x) }
    if (sub(/^\(/, "", rest)) { x = sum(); sub(/^ *\)/, "", rest); return x }
    if (match(rest, /^\[[^]]*\]/)) {
        x = substr(rest, 2, RLENGTH - 2)
        rest = substr(rest, RLENGTH + 1)
        return reference(x)
    }
    if (!match(rest, /^[0-9.]+(e[-+]?[0-9]+)?/)) {
        print page ": not understood: " rest > "/dev/stderr"
        failed = 1
        rest = ""
        return 0
    }
    x = substr(rest, 1, RLENGTH)
    rest = substr(rest, RLENGTH + 1)
    return x
}
function product(  x, y) {
    for (x = factor(); match(rest, /^ *[*\/]/);) {
        y = substr(rest, RLENGTH, 1); rest = substr(rest, RLENGTH + 1)
        if (y == "*") x *= factor(); else { y = factor(); if (y + 0 == 0) missing = 1; else x /= y }
    }
    return x
}
function sum(  x, y) {
    for (x = product(); match(rest, /^ *[-+]/);) {
        y = substr(rest, RLENGTH, 1); rest = substr(rest, RLENGTH + 1)
        if (y == "+") x += product(); else x -= product()
    }
    return x
}
# inside(x): whether a <= x <= b; the range of a text is "=TEXT" in a
function inside(x, a, b) {
    if (a ~ /^=/) return x == substr(a, 2)
    return (a == "" || x + 0 >= a + 0) && (b == "" || x + 0 <= b + 0)
}
function filled(text,  out, body, format, range, judged, x, all, met, lost, found) {
    gsub(/@/, key, text)
    while (match(text, /\{[^{}]*\}/)) {
        out = out substr(text, 1, RSTART - 1)
        body = substr(text, RSTART + 1, RLENGTH - 2)
        text = substr(text, RSTART + RLENGTH)
        range = low ":" high
        if (match(body, / [-0-9.e]*:[-0-9.e]*$/)) {
            range = substr(body, RSTART + 1)
            body = substr(body, 1, RSTART - 1)
        }
        judged = !sub(/^~/, "", body) && range != ":"
        format = "%s"
        if (match(body, / %[^ ]*$/)) { format = substr(body, RSTART + 1); body = substr(body, 1, RSTART - 1) }
        rest = body; missing = 0
        x = body ~ /^\[[^]]*\]$/ ? reference(substr(body, 2, length(body) - 2)) : sum()
        if (missing) { out = out "–"; lost++; continue }
        found++
        if (judged) {
            all++
            met += inside(x, substr(range, 1, index(range, ":") - 1), substr(range, index(range, ":") + 1))
        }
        x = sub(/,/, "", format) ? thousands(sprintf(format, x)) : sprintf(format, x)
        if (x ~ /^-[0.]*$/) x = substr(x, 2)
        out = out x
    }
    out = lost && !found ? "–" : out text
    if (all && !lost) out = out (met == all ? " ✓" : met ? " in part" : " ✗")
    return out
}
# thousands(x): with a comma between thousands
function thousands(x,  out) {
    while (x + 0 >= 1000 && match(x, /[0-9][0-9][0-9]$/)) {
        out = "," substr(x, RSTART) out
        x = substr(x, 1, RSTART - 1)
    }
    return x out
}
function asked() {
    if (low ~ /^=/) return substr(low, 2)
    if (low "" == high "") return low
    return low == "" ? "at most " high : high == "" ? "at least " low : low " to " high
}
function table(path,  line, name, cell, n, m, i, out, number) {
    while ((getline line < path) > 0) {
        split("", cell)
        i = csv(line, cell)
        if (!number++) for (n = m = i; m; m--) name[m] = cell[m]
        if (i != n) {
            print path ": " i " cells in place of " n ": " line > "/dev/stderr"
            failed = 1
        }
        key = low = high = ""
        for (i = 1; i <= n && number > 1; i++) {
            if (name[i] == "key") key = cell[i]
            if (name[i] == "low") low = cell[i]
            if (name[i] == "high") high = cell[i]
        }
        out = "|"
        for (i = 1; i <= n; i++)
            if (name[i] !~ /^(key|low|high)$/)
                out = out " " (number == 1 ? name[i] : name[i] == "asked" ? asked() : filled(cell[i])) " |"
        gsub(/  \|/, " |", out)
        print out
        if (number == 1) { gsub(/[^|]+/, "---", out); print out }
    }
    close(path)
    if (!number) { print page ": no table " path > "/dev/stderr"; failed = 1 }
}
/^<!-- statements: / {
    print
    print ""
    folder = $4
    table(dirname $3)
    print ""
    skip = 1
    next
}
/^<!-- end -->/ { skip = 0 }
!skip
BEGIN { dirname = page; sub(/[^\/]*$/, "", dirname) }
END { exit failed }
