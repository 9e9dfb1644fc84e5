#!/bin/sh
# Prints the decay rate of the vortices' velocity over the exact 2 nu, from the kinetic energy at the run's end. The
# exact energy is rho V/4 exp(-4 nu t).
# usage: rate.sh VISCOSITY, in the run folder
awk -F, -v nu="$1" 'NR == 1 { for (i = 1; i <= NF; i++) k[$i] = i } NR > 2 { e = $k["e_kinetic_fluid"]; t = $k["t"] }
  END { pi = atan2(0, -1); printf "%.14g\n", log(4 * pi * pi * 4 / 4 / e) / (4 * nu * t) }' series.csv
