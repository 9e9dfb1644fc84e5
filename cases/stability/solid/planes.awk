# Prints a setting with `planes` cracks across the body of 6 particles, along x, y, z in turn.
BEGIN {
  split("[a, -1, -1], [a, 7, -1], [a, 7, 7], [a, -1, 7];[-1, a, -1], [7, a, -1], [7, a, 7], [-1, a, 7];" \
    "[-1, -1, a], [7, -1, a], [7, 7, a], [-1, 7, a]", across, ";")
  printf "solid.cracks=["
  for (k = 0; k < planes; k++) {
    points = across[k % 3 + 1]
    gsub("a", int(k / 3) + 1, points)
    printf "%s{points: [%s]}", k ? ", " : "", points
  }
  print "]"
}
