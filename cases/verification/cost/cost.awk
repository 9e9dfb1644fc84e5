# The counted cost of a run's elastic steps, s of one core: what the run did, times medians of `frana bench` on 2 quiet
# cores (revision de4e711c). Contact's iterations depend on the pairs that touch, so its cost is its time over that of
# the sweeps in the same run, times the sweeps' counted cost. Prints steps, force sweeps, seconds.
# usage: awk -v from=T -f cost.awk run.json scene.resolved.yaml series.csv        T: when the solid becomes elastic
# ns: of a fluid's step, a cell; of the forcing, a marker in the three stages (reaction) or a marker and iteration; of
# a probe; of weights, a marker or particle; of a sweep, a directed bond
BEGIN {
  of_cell = 33.9; of_feedback = 258; of_iteration = 168; of_probe = 217; of_weights = 84
  of_bond = 1.05; of_damped = 1.55
}
FILENAME ~ /json$/ {
  split($0, word, /[":, ]+/)
  if (word[2] == "cells") cells = word[3]
  if (word[2] == "particles") particles = word[3]
  if (word[2] == "directed_bonds") bonds = word[3]
  if (word[2] == "ns_per_directed_bond_sweep") per_sweep = word[3]
  if (word[2] == "solid" && seconds == "") seconds = word[3]
  if (word[2] == "wall_seconds_by_part") parts = 1 # before it, "contact" counts what bound the substeps
  if (word[2] == "contact" && parts && touching == "") touching = word[3]
  next
}
FILENAME ~ /yaml$/ {
  if ($1 == "load:") load = $2
  if ($1 == "forcing_iterations:") iterations = $2
  if ($1 == "fluid_integrator:" && $2 == "ab2") one_stage = 1 # of three; in all elastic stages
  if ($1 == "damping_relative:" && $2 > 0) of_bond = of_damped
  next
}
FNR == 1 { n = split($0, name, ","); for (i = 1; i <= n; i++) c[name[i]] = i; next }
FNR == 2 { next }
{
  split($0, v, ",")
  markers = v[c["interface_particles"]]
  if (v[c["t"]] > from + 1e-9) steps = v[c["step"]] - before; else before = v[c["step"]]
}
END {
  if (one_stage) { of_cell /= 3; of_feedback /= 3; of_iteration /= 3 }
  sweeps = per_sweep > 0 ? int(1e9 * seconds / per_sweep / bonds + 0.5) : 0
  step = of_cell * cells + of_weights * markers
  if (load == "reaction") step += of_feedback * markers + (sweeps > 0) * of_weights * particles
  else step += of_iteration * iterations * markers + (sweeps > 0) * (of_weights + of_probe) * markers
  contact = sweeps > 0 ? touching / seconds : 0
  printf "%d,%d,%.4g\n", steps, sweeps, 1e-9 * (steps * step + sweeps * bonds * of_bond * (1 + contact))
}
