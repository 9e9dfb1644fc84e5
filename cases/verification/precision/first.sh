#!/usr/bin/env bash
# Time at which the first bond breaks, s, from events.csv in the folder where it is called.
set -euo pipefail
awk -F, '$1 ~ /^[0-9]/ { print $2; exit }' events.csv
