# The displacement of the particle above the tip of the notch: gnuplot -c notch.gp OUT, in the folder of the runs
set terminal pngcairo size 900,560
set output ARG1.'/notch_displacement.png'
set datafile separator ','
set xlabel 't, us'
set ylabel 'displacement above the tip of the notch, mm'
set key top left
plot for [n in 'uniform_4000 uniform_16000 adaptive'] for [c in 'x y'] n.'/probes.csv' every ::2 \
  using (1e6*$2):(1e3*(c eq 'x' ? $6 : $7)) with lines lw 1.5 title n.', '.c noenhanced
