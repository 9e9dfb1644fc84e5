#!/bin/sh
# Prints a number of a calibration. usage: value.sh FOLDER MATERIAL QUANTITY [100 | 110 | ANGLE deg]
case ${4-} in 100 | 110) direction="[$4]" ;; *) direction="${4-}${5:+ $5}" ;; esac
awk -F, -v m="$2" -v q="$3" -v d="$direction" '$1 == m && $2 == q && $3 == d { print $4; found = 1 }
  END { exit !found }' "$1/calibration.csv"
