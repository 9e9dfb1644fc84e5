#!/bin/sh
# In a run folder: the tip's displacement along the stream in the end, m.
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "displacement_x") at = i } END { print $at }' probes.csv
