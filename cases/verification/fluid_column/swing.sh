#!/bin/sh
# Prints a measure of displacement_x of the bar's face, from probes.csv in the run folder:
#   frequency  over the whole periods between its zero crossings, rad/s
#   skin       cells by which a load at rest on its markers finds the bar longer than its frequency does: the
#              displacement of the markers, 1.24 of the outermost layer's less 0.24 of the next one's, times C11, less
#              the length that acts
#   ratio      the frequency over the exact one of the bar with its column, with the frequency of the bar alone at
#              1000 kg/m3 and 16 cells (study_dry) and its skin (study_loaded); both are run before, to the same --out
#   growth     amplitude after a period over that before, by the Fourier integrals of the first and the last one
#   late       largest displacement of the second half of the run over that of the first
#   across     the same of displacement_y, which starts at 0 and is round-off unless it grows
# usage: swing.sh frequency|skin|ratio|growth|late|across
number() { sed -n "/^$1:/,/^$2:/s/.*$3: *\[*\([0-9.e+-]*\).*/\1/p" scene.resolved.yaml | head -n 1; }
alone() { # alone STUDY LEVEL: the number of the bar alone, from the study's table beside the folder of all runs
  sed -n "s/^bar,$2,,[^,]*,[^,]*,\([^,]*\),.*/\1/p" "../../../../../$1.csv" 2>/dev/null
}
awk -F, -v what="$1" -v dry="$(alone study_dry alone)" -v skin="$(alone study_loaded loaded)" \
  -v solid="$(number solid coupling density)" -v fluid="$(number fluid solid density)" \
  -v size="$(number domain fluid size)" -v cells="$(number domain fluid cells)" '
  function exact(  c, l, x, low, high, q, k) { # a bar that acts from 0 to l; c is its speed at 1000 kg/m3
    c = sqrt(1.2 * 1.02041 * 1e6 / 1000)
    l = 0.016 + (pi / 2 * c / dry / 0.001 - 16) * size / cells; skin *= size / cells
    x = solid * l / (fluid * (size - 0.016)); low = 0; high = pi / 2
    for (k = 0; k < 60; k++) { q = (low + high) / 2
      if (q * sin(q) / cos(q) + q * q * skin / l > x) high = q; else low = q }
    return c * sqrt(1000 / solid) * q / l }
  function amplitude(from, to,  i, re, im, n) {
    for (i = 1; i <= samples; i++) if (at_t[i] >= from && at_t[i] < to) {
      re += xs[i] * cos(w * at_t[i]); im += xs[i] * sin(w * at_t[i]); n++ }
    return sqrt(re * re + im * im) / n }
  NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR <= 2 { next }
  { t = $at["t"]; x = $at[what == "across" ? "displacement_y" : "displacement_x"]
    if (x * last < 0) { n++; zero[n] = was + (t - was) * last / (last - x) }
    at_t[++samples] = t; xs[samples] = x
    last = x; was = t }
  END { pi = atan2(0, -1); c11 = 1.2 * 1.02041 * 1e6
    if (!dry && what ~ /ratio|skin/ || !skin && what == "ratio") { print "first run study_dry, study_loaded"; exit 1 }
    if (what == "skin") {
      printf "%.6g\n",
        ((1.24 * xs[samples - 1] - 0.24 * xs[samples]) * c11 - pi / 2 * sqrt(c11 / 1000) / dry) / 0.001; exit }
    if (what == "late" || what == "across") {
      for (k = 1; k <= samples; k++) { y = xs[k] < 0 ? -xs[k] : xs[k]; half = k > samples / 2
        if (y > most[half]) most[half] = y }
      printf "%.6g\n", most[1] / most[0]; exit }
    if (n % 2 == 0) n-- # whole periods: the bar swings about a place that is not quite 0
    if (n < 5) exit 1
    periods = (n - 1) / 2; w = 2 * pi * periods / (zero[n] - zero[1])
    if (what == "growth")
      printf "%.6g\n", (amplitude(zero[n - 2], zero[n]) / amplitude(zero[1], zero[3])) ^ (1 / (periods - 1))
    else printf "%.10g\n", what == "ratio" ? w / exact() : w }' probes.csv
