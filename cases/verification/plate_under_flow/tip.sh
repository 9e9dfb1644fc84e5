#!/bin/sh
# Prints, in a run folder, the tip's displacement along the stream at the end, m.
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "displacement_x") at = i } END { print $at }' probes.csv
