# Errors of a method against the horizon over the spacing, m, in a table of a study, whose rows are in order of m.
# usage: awk -F, -f errors.awk -v method=METHOD -v step=STEP [-v from=M] TABLE     m = 2 or `from`, ... 5 in steps
# Prints how often the error rises; with `from` the largest over the least.
/^#/ { next }
!("value" in at) { for (i = 1; i <= NF; i++) at[$i] = i; next }
$1 == method && $at["quantity"] == "error_l2" {
  m = substr($2, 3)
  if (m < from || m / step != int(m / step)) next
  e = $at["value"]
  if (n++ && e > before) rises++
  if (n == 1 || e < low) low = e
  if (e > high) high = e
  before = e
}
END { if (!n) exit 1; print from ? high / low : rises + 0 }
