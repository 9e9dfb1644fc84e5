#!/usr/bin/env bash
# Permeability of a sample of Berea sandstone along its three axes, beside a lattice-Boltzmann code's on the same
# voxels.
# The image is not in the repository: README.md says where it can be had. It is looked for in this folder.
# usage: cases/berea/run.sh [FRANA [RUNS [OUT]]]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../verification/common.sh" "$@"
image=$here/berea_pore_110x110x110_uint8.raw
[ "$again" ] || [ -f "$image" ] || { echo "there is no $image; see $here/README.md" >&2; exit 4; }
study study
near "porosity" 1 "$(cell study value 'along z' 1 porosity)" 0.177884 "236764 of 1331000 voxels" 1e-5
for method in 'along z' 'along z implicit' 'along y implicit' 'along x implicit'; do
  shown "one cell a voxel, $method: permeability" voxel2 "$(cell study value "$method" 1 permeability)" \
    "$([[ $method = *z* ]] && echo 0.4459)" "LBPM, MRT, along z"
  shown "one cell a voxel, $method: wall time" s "$(cell study wall_median_s "$method" 1 permeability)" "" ""
done
finish
