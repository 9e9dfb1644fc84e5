#!/usr/bin/env bash
# The table that demo.sh prints of a run's summary: whole numbers as they are, others to five digits, quoted fields, a
# choice of rows.
# usage: summary.sh SOURCE
set -euo pipefail
table='quantity,unit,value
# a comment
bonds broken,1,187753
largest fragment,particles,1234567
least,Pa,-72012
"damage, mean",1,0.3344412
k,m2,3.2879999e-06
title,,"A block, breaking"'
said=$(awk -f "$1/tools/summary.awk" <<<"$table" | sed 's/  */ /g')
want=' bonds broken 187753
 largest fragment 1234567 particles
 least -72012 Pa
 damage, mean 0.33444
 k 3.288e-06 m2
 title A block, breaking'
diff <(echo "$want") <(echo "$said")
said=$(awk -v only='k|damage, mean|none' -f "$1/tools/summary.awk" <<<"$table" | sed 's/  */ /g')
diff <(grep -E '^ (k|damage)' <<<"$want") <(echo "$said")
echo ok
