# gnuplot -e "folder = 'results'" ensemble.gp
set datafile separator ","
set terminal pngcairo size 1100,1000
set output folder . "/ensemble.png"
file = folder . "/ensemble.csv"
set multiplot layout 3,2
set xlabel "time since bonds may break, ms"
set key top left
set style fill transparent solid 0.3 noborder
do for [q = 0:2] {
  set ylabel q == 0 ? "pressure drop / p0" : q == 1 ? "bonds broken, %" : "porosity"
  do for [load in "probe reaction"] {
    set title load
    plot for [s = 1:3] file every ::1 \
           using (strcol(1) eq load . "-S" . s ? 1e3 * $3 : NaN):(column(4 + 3 * q)):(column(6 + 3 * q)) \
           with filledcurves lc s notitle, \
         for [s = 1:3] file every ::1 using (strcol(1) eq load . "-S" . s ? 1e3 * $3 : NaN):(column(5 + 3 * q)) \
           with lines lw 1.5 lc s title "S" . s
  }
}
unset multiplot
