# the mean of a column over the last seconds of series.csv, by the trapezium rule:
# awk -F, -v column=dp -v last=1e-3 -f mean.awk series.csv
NR == 1 { for (i = 1; i <= NF; i++) if ($i == column) k = i; next }
NR > 2 { t[++n] = $2; y[n] = $k }
END {
    for (i = n; i > 1 && t[n] - t[i - 1] <= last; i--) sum += (y[i] + y[i - 1]) / 2 * (t[i] - t[i - 1])
    printf "%.10g\n", sum / (t[n] - t[i])
}
