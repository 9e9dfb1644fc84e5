# Draws light.png from the map's numbers; run by edge.sh in the folder of the results.
set logscale x; set xlabel 'E/Pa'; set ylabel 'strain energy, last over middle third of the run'; set yrange [0.5:2]
of(s, d, r) = strcol(1) eq s && $2 == d && $3 == r ? $5 : NaN
f = "<sed 's/\"//g; s/ /,/g' measured.csv"
plot for [r in '0.02 0.1 0.5'] f using 4:(of('rk3', 4, r + 0)) with points title 'RK3, 4 ms, density ratio '.r, \
  for [r in '0.02 0.1'] f using 4:(of('ab2', 4, r + 0)) with points title 'AB2, 4 ms, density ratio '.r, \
  for [r in '0.02 0.1'] f using 4:(of('rk3', 1, r + 0)) with points title 'RK3, 1 ms, density ratio '.r, \
  for [r in '0.02 0.1'] f using 4:(of('rk3', 12, r + 0)) with points title 'RK3, 12 ms, density ratio '.r, \
  1.5 with lines lc 'black' notitle
