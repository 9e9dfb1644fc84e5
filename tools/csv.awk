# csv(line, cell): splits a line of a table into cells; a cell with a comma or a quote is in double quotes.
function csv(line, cell,  n, text) {
    n = 0
    while (match(line, /^("([^"]|"")*"|[^,]*)(,|$)/)) {
        text = substr(line, 1, RLENGTH)
        line = substr(line, RLENGTH + 1)
        if (sub(/,$/, "", text)) last = 1; else last = 0
        if (sub(/^"/, "", text)) { sub(/"$/, "", text); gsub(/""/, "\"", text) }
        cell[++n] = text
        if (!last) break
    }
    return n
}
