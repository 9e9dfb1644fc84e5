#!/usr/bin/env bash
# Permeability of a simple cubic array of spheres along [100], [110] and [111], until it is steady; and the tensor.
# usage: cases/verification/tensor/run.sh [FRANA [RUNS [OUT [quick]]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../common.sh" "$@"
# compare STUDY LEVEL TOLERANCE: with Zick and Homsy, and the slanted directions with [100]
compare() {
  for c in 0.125 0.343; do
    for e in 100 110 111; do
      near "c = $c at $2^3: k along [$e] over the reference" 1 "$(cell "$1" value "$c along $e" "$2" permeability)" 1 \
        "Zick and Homsy 1982" "$3"
    done
    for e in 110 111; do
      near "c = $c at $2^3: k along [$e]" 1 "$(cell "$1" value "$c along $e" "$2" permeability)" \
        "$(cell "$1" value "$c along 100" "$2" permeability)" "along [100]: the tensor is isotropic" 0.002
    done
  done
}
study study
compare study 24 0.03
if [ ! "$quick" ]; then
  study study_fine
  compare study_fine 48 0.02
fi
# the whole tensor at 24 cells, by frana permeability
if [ ! "$again" ]; then
  "$frana" permeability "$here/scene.yaml" --stepped --out "$runs/tensor" --set 'domain.cells=[24, 24, 24]' --quiet \
    --fresh >"$runs/tensor.log"
fi
tensor() { awk -F, -v q="$1" '$1 == q { print $2 }' "$runs/tensor/permeability.csv"; }
part() { calc "$(tensor "$1") / $(tensor k_xx)"; }
for q in k_yy k_zz; do
  near "tensor at 24^3: $q over k_xx" 1 "$(kept "$q over k_xx" part $q)" 1 isotropy 0.002
done
for q in k_xy k_xz k_yz; do
  row "tensor at 24^3: $q over k_xx" 1 "$(kept "$q over k_xx" part $q)" 0 isotropy -0.001 0.001
done
row "tensor at 24^3: asymmetry" 1 "$(kept asymmetry tensor asymmetry)" 0 symmetry 0 1e-4
finish
