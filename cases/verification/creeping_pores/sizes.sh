#!/usr/bin/env bash
# Iterations, products, memory and time of creeping flow through samples of rock, on RANKS ranks (2 if it is not set).
# Berea and FiberForm need their images (cases/berea, cases/fiberform); what has none is left out. `large` adds a
# synthetic rock of 512^3 voxels (about 6 GB, some minutes). k is in squares of a voxel.
# usage: sizes.sh [FRANA [RUNS [OUT [large]]]]    writes OUT/sizes.csv
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
frana=$(realpath "${1:-build/frana}") runs=${2:-runs/verification/creeping_pores_sizes}
out=$(realpath "${3:-$here/results}")
mkdir -p "$runs" "$out" && cd "$runs"
berea=$here/../../berea fiberform=$here/../../fiberform

row() { # row NAME RUN VOXEL LEVEL [CELLS_A_VOXEL]: of a finished run
  awk -F, -v name="$1" -v voxel="$3" -v level="$4" -v cells="${5:-$4}" '
    { v[$1] = $2 }
    END {
      l = "_level_" level
      printf "%s,%d,%d", name, cells, v["pore_cells" l]
      for (c = 1; c <= 3; c++) { a = substr("xyz", c, 1); printf ",%.6g", v["k_" a a l] / voxel ^ 2 }
      for (c = 1; c <= 3; c++) { a = substr("xyz", c, 1); printf ",%d", v["iterations_" a l] }
      for (c = 1; c <= 3; c++) { a = substr("xyz", c, 1); printf ",%d", v["products_" a l] }
      printf ",%.1f,%.3g,%.3g\n", v["bytes" l] / v["pore_cells" l], v["seconds" l],
        1e6 * v["seconds" l] / v["pore_cells" l]
    }' "$2/permeability.csv" | tee -a sizes.new
}
permeability() { mpiexec -n "${RANKS:-2}" "$frana" permeability "$@" --quiet >log || { cat log >&2; exit 1; }; }
voxels() { # voxels NAME N: a synthetic rock
  local edges="[$2, $2, $2]"
  ./noise "$2" >"noise_$2.raw"
  permeability "$here/scene.yaml" --quick --out "noise_$2" --set "domain={size: $edges, cells: $edges}" \
    --set "coupling.medium={low: [0, 0, 0], high: $edges}" --set "solid.bodies=[{name: rock, shape: image,
    file: '$PWD/noise_$2.raw', size: $edges, type: uint8, voxel: 1, solid: [1], low: [0, 0, 0]}]"
  row "$1" "noise_$2" 1 1
}
echo "sample,cells a voxel,pore cells,k_xx,k_yy,k_zz,iterations x,iterations y,iterations z,products x,products y,\
products z,bytes a pore cell,seconds,us a pore cell" >sizes.new
if [ -f "$berea/berea_pore_110x110x110_uint8.raw" ]; then
  permeability "$berea/scene.yaml" --quick --out berea
  row "Berea 110^3 between open layers" berea 5e-6 1
  permeability "$berea/scene.yaml" --quick --out mirrored --set solid.bodies.rock.mirror=xyz \
    --set solid.bodies.rock.low='[0, 0, 0]' --set 'domain={size: [11e-4, 11e-4, 11e-4], cells: [220, 220, 220]}' \
    --set 'coupling.medium={low: [0, 0, 0], high: [11e-4, 11e-4, 11e-4], direction: z}'
  row "Berea mirrored 220^3" mirrored 5e-6 1
  cut=(--set solid.bodies.rock.low='[0, 0, 0]' --set 'domain={size: [5.5e-4, 5.5e-4, 5.5e-4], cells: [110, 110, 110]}'
    --set 'coupling.medium={low: [0, 0, 0], high: [5.5e-4, 5.5e-4, 5.5e-4], direction: z}')
  permeability "$berea/scene.yaml" --quick --out periodic "${cut[@]}"
  row "Berea 110^3 between periodic sides" periodic 5e-6 1
  permeability "$berea/scene.yaml" --quick --out pressures "${cut[@]}" --set 'fluid={density: 1000, viscosity: 1.0e-6,
    sides: {x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: periodic}, y_high: {type: periodic},
    z_low: {type: pressure, pressure: 1}, z_high: {type: pressure}}}'
  row "Berea 110^3 between given pressures" pressures 5e-6 1
  part=(--set 'domain.size=[3.2e-4, 3.2e-4, 3.7e-4]' --set 'solid.bodies.rock.crop={low: [0, 0, 0], high: [64, 64, 64]}'
    --set 'coupling.medium={low: [0, 0, 2.5e-5], high: [3.2e-4, 3.2e-4, 3.45e-4], direction: z}')
  permeability "$berea/scene.yaml" --out part "${part[@]}" --set 'domain.cells=[64, 64, 74]'
  row "Berea 64^3" part 5e-6 1
  row "Berea 64^3" part 5e-6 2
  awk -F, '$1 == "k_zz" { k = $2 } $1 == "k_zz_error" { e = $2 }
    END { printf "Berea 64^3 from two grids,,,,,%.6g +- %.2g,,,,,,,,,\n", k / 25e-12, e / 25e-12 }' \
    part/permeability.csv | tee -a sizes.new
  permeability "$berea/scene.yaml" --quick --out part3 "${part[@]}" --set 'domain.cells=[192, 192, 222]' \
    --set solid.spacing=1.6666666666666667e-6
  row "Berea 64^3" part3 5e-6 1 3
fi
if [ -f "$fiberform/fiberform_100.tif" ]; then
  permeability "$fiberform/scene.yaml" --quick --out fiberform
  row "FiberForm 100^3 between open layers" fiberform 1.3e-6 1
fi
"${CC:-cc}" -O2 -o noise "$here/noise.c"
voxels "Synthetic rock 192^3" 192
[ "${4-}" != large ] || voxels "Synthetic rock 512^3" 512
mv sizes.new "$out/sizes.csv"
