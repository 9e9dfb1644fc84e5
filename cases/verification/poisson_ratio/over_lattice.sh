#!/bin/sh
# Prints, in a run folder, a bar's modulus over that of the lattice with the scene's Poisson's ratio, along [100].
awk -v m=3 -v nu="$(awk '$1 == "poisson_ratio:" { print $2 }' scene.resolved.yaml)" -f "$FRANA_STUDY/../lattice.awk" |
  awk -v ours="$("$FRANA_STUDY/../bar/modulus.sh")" '$1 == "e100" { printf "%.12g\n", ours / $2 }'
