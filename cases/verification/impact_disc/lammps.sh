#!/usr/bin/env bash
# Makes lammps.csv and lammps_modes.csv again: energies, mean damage and its azimuthal modes in LAMMPS's run of in.disc.
# usage: lammps.sh [LMP]          (minutes)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"${1:-lmp}" -in "$here/in.disc" -var dump "$work/dump" -log "$work/log" -screen none
awk -f "$here/lammps_log.awk" "$work/log" >"$here/lammps.csv"
awk -f "$here/lammps_modes.awk" "$work/dump" >"$here/lammps_modes.csv"
