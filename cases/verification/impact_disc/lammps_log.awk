# A log of in.disc as a table; pe and ke are sums of energies per volume of 1.25e-10 m3.
/^LAMMPS \(/ { print "# " $0 }
/total # of bonds/ { bonds = $NF }
/^Step/ { on = 1; next }
on && $1 + 0 == $1 && $2 + 0 == $2 && $1 <= 600 {
  e[++n] = sprintf("%d,%.15g,%.15g,%.15g", $1, $3 * 1.25e-10, $4 * 1.25e-10, $5)
  atoms = $2
}
END {
  print "# " atoms " particles, " bonds " directed bonds"
  print "step,e_strain,e_kinetic,damage_mean"
  for (i = 1; i <= n; i++) print e[i]
}
