#!/usr/bin/env bash
# Makes lammps.csv and impact.csv again: the energies of LAMMPS's runs of in.wave and in.impact, in joules.
# usage: lammps.sh [LMP]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"${1:-lmp}" -in "$here/in.wave" -var steps 100 -log "$work/log" -screen none
awk -v volume=1.25e-13 '
  /^LAMMPS \(/ { print "# " $0 }
  /total # of bonds/ { bonds = $NF }
  /^Step/ { run++; next }
  run == 3 && NF == 5 && $1 + 0 == $1 { e[++n] = sprintf("%d,%.15g,%.15g", $1, $3 * volume, $4 * volume); atoms = $2;
    worst = $5 }
  END {
    if (worst != 0) exit 1
    print "# " atoms " particles, " bonds " directed bonds"
    print "step,e_strain,e_kinetic"
    for (i = 1; i <= n; i++) print e[i]
  }' "$work/log" | tee "$here/lammps.csv"
"${1:-lmp}" -in "$here/in.impact" -var steps 200 -log "$work/log" -screen none
awk -v volume=1.25e-10 '
  /^LAMMPS \(/ { print "# " $0 }
  /total # of bonds/ { bonds = $NF }
  /^Step/ { run++; next }
  run == 1 && NF == 5 && $1 + 0 == $1 { e[++n] = sprintf("%d,%.15g,%.15g", $1, $3 * volume, $4 * volume); atoms = $2 }
  END {
    print "# " atoms " particles, " bonds " directed bonds"
    print "step,e_strain,e_kinetic"
    for (i = 1; i <= n; i++) print e[i]
  }' "$work/log" | tee "$here/impact.csv"
