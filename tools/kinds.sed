# The kinds of cases/kinds.csv in words, as rows of a table.
s/^independent \(.*\) \(.*\)/| exact solutions, sums over the lattice, experiments and published numbers | \1 | \2 |/
s/^program \(.*\) \(.*\)/| numbers of another program | \1 | \2 |/
s/^invariant \(.*\) \(.*\)/| what must hold exactly: balances, symmetries, orders of the scheme, physical bounds | \1 | \2 |/
s/^own \(.*\) \(.*\)/| another run of frana: finer, or by another method | \1 | \2 |/
s/^stability \(.*\) \(.*\)/| stability: a run holds, or nothing grows | \1 | \2 |/
