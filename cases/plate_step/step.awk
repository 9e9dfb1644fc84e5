# Energies and displacements of a plate under a step load, from tables of runs (series.csv, probes.csv), that on the
# uniform coarse grid first.
# usage: awk -F, -v what=WHAT [-v probe=P -v column=C] -f step.awk [UNIFORM] TABLE
#     unbalanced   largest |kinetic + strain energy - work of load and support| over the largest energy, % (one table)
#     deviation    largest difference between the total energy and the uniform one, over the largest energy, %
#     lost         largest loss against the uniform energy at the same time, over that energy, %
#     peak         greatest size of the column at the probe, over the uniform one less 1, %
#     last         the last value of the column at the probe, over the uniform one less 1, %
FNR == 1 { table++; delete k; for (i = 1; i <= NF; i++) k[$i] = i }
FNR <= 2 { next }
{ e = $k["e_kinetic_solid"] + $k["e_strain"]; s = $k["step"] }
what == "unbalanced" {
  d = e - $k["work_load"] - $k["e_constraint"]
  if (e > top) top = e
  if (d * d > most * most) most = d < 0 ? -d : d
}
(what == "deviation" || what == "lost") && table == 1 { uniform[s] = e; if (what != "lost" && e > top) top = e }
what == "deviation" && table == 2 { d = uniform[s] - e; if (d * d > most * most) most = d }
what == "lost" && table == 2 { top = 1; if ((d = 1 - e / uniform[s]) > most) most = d }
(what == "peak" || what == "last") && $k["probe"] == probe {
  v = $k[column]
  if (what == "peak" && v < 0) v = -v
  if (what == "last" || v > value[table]) value[table] = v
}
END { print what == "peak" || what == "last" ? 100 * (value[2] / value[1] - 1) : 100 * most / top }
