# Prints a table of runs from a case's measured.csv, whose lines are "RUN: NUMBER",value. Numbers are as they are kept,
# or are multiplied by FACTOR.
#   awk -v runs="RUN RUN ..." -v columns="HEAD=NUMBER[*FACTOR]|..." [-v grids=1] -f table.awk measured.csv
# grids: the name of a run is CHOICE_PARTICLES, and each has a column
{ at = index($0, "\","); value[substr($0, 2, at - 2)] = substr($0, at + 2) }
END {
  n = split(columns, column, "|")
  head = grids ? "choice, particles" : "choice"
  for (k = 1; k <= n; k++) {
    split(column[k], part, "="); head = head ", " part[1]
    split(part[2], its, "*"); key[k] = its[1]; factor[k] = its[2]
  }
  print head
  rows = split(runs, run, " ")
  for (r = 1; r <= rows; r++) {
    line = run[r]
    if (grids) { at = match(line, /_[0-9]+$/); line = substr(line, 1, at - 1) ", " substr(line, at + 1) }
    for (k = 1; k <= n; k++) {
      v = value[run[r] ": " key[k]]
      line = line ", " (factor[k] && v != "" ? sprintf("%.6g", factor[k] * v) : v)
    }
    print line
  }
}
