#!/usr/bin/env bash
# Prints the accelerations of LAMMPS's run of in.released at the five probes of released.yaml, m/s2: a line x,y,z each.
# usage: lammps.sh [LMP]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
"${1:-lmp}" -in "$here/in.released" -var K 24444444444.44444 -var G 7333842281.774293 -log log -screen none
for site in "8 8 8" "6 8 7" "9 6 8" "10 10 10" "6 6 6"; do # along x, y, z, from 0
  read -r i j k <<<"$site"
  awk -v id=$((1 + i + 17 * (j + 17 * k))) '/TIMESTEP/ { frame++ }
    NF == 4 && $1 == id { for (c = 0; c < 3; c++) v[frame, c] = $(c + 2) }
    END { for (c = 0; c < 3; c++) printf "%.15g%s", 2e7 * (v[2, c] - v[1, c]), c < 2 ? "," : "\n" }' released.txt
done
