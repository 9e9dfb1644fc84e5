#!/bin/sh
# Prints the imbalance of energy in a run folder's series.csv, from the first elastic step on, over the energy that was
# put in. Put in is the gradient's work int G u_bulk V dt, or without a gradient the solid's energy at the start.
# Integrals are by the trapezium rule, those of means over a step by its length.
#   whole   d(fluid's + solid's energy) + damped + fracture + int (dissipation + slip's loss - inner fluid's power) dt
#           - put in; slip's loss and inner fluid's power are of the load by reaction alone
#   rigid   the same before the solid is released, over the gradient's work until then, from a quarter of that time on
#   solid   d(solid's energy) + damped + fracture - work of the fluid on it
#   work    work of the fluid on the solid
#   broken  broken bonds
# usage: budget.sh whole|rigid|solid|work|broken
g=$(sed -n '/driving:/,$s/.*value: *\([0-9.e+-]*\).*/\1/p' scene.resolved.yaml | head -n 1)
v=$(sed -n 's/.*size: *\[\([^]]*\)\].*/\1/p' scene.resolved.yaml | awk -F, '{ print $1 * $2 * $3 }')
awk -F, -v what="$1" -v g="${g:-0}" -v v="$v" '
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR <= 2 { next }
  {
    n++
    t[n] = $at["t"]; spent[n] = $at["dissipation"]; put[n] = g * v * $at["u_bulk"]; f[n] = $at["e_kinetic_fluid"]
    s[n] = $at["e_kinetic_solid"] + $at["e_strain"] + $at["e_damped"] + $at["e_fracture"]
    w[n] = $at["work_fluid"]; broken = $at["bonds_broken"]
    loss[n] = ("slip_loss" in at ? ($at["slip_loss"] - $at["inner_power"]) * (t[n] - t[n - 1]) : 0) + loss[n - 1]
    if (s[n] == 0) still = n
  }
  function integral(q, a, b,  i, sum) {
    for (i = a + 1; i <= b; i++) sum += (q[i] + q[i - 1]) / 2 * (t[i] - t[i - 1])
    return sum
  }
  function whole(a, b) { 
    return f[b] - f[a] + s[b] - s[a] + integral(spent, a, b) + loss[b] - loss[a] - integral(put, a, b)
  }
  END {
    if (what == "broken") { print broken; exit }
    first = still ? still : 1
    all = integral(put, first, n)
    if (all == 0) all = s[first]
    if (what == "rigid") { first = int(still / 4); print whole(first, still) / integral(put, first, still) }
    if (what == "whole") print whole(first, n) / all
    if (what == "solid") print (s[n] - s[first] - w[n] + w[first]) / all
    if (what == "work") print (w[n] - w[first]) / all
  }' series.csv
