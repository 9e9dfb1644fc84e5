#!/usr/bin/env bash
# Permeability of a carbon-fibre insulator along its three axes, and a part of it broken by the flow.
# The image is not in the repository: README.md says where it can be had. It is looked for in this folder.
# usage: cases/fiberform/run.sh [FRANA [RUNS [OUT]]]
#        cases/fiberform/run.sh --summary [OUT]
# shellcheck source=cases/verification/common.sh
. "$(dirname "$0")/../verification/common.sh" "$@"
# shellcheck source=cases/rock.sh
. "$here/../rock.sh"
image=$here/fiberform_100.tif
[ "$again" ] || [ -f "$image" ] || { echo "there is no $image; see $here/README.md" >&2; exit 4; }
study study
shown "porosity" 1 "$(cell study value 'along z' 1 porosity)" 0.83286 "832860 of 1000000 voxels"
for axis in z y x; do
  shown "1 cell a voxel, along $axis: permeability" voxel2 "$(cell study value "along $axis" 1 permeability)" "" ""
  shown "1 cell a voxel, along $axis: wall time" s "$(cell study wall_median_s "along $axis" 1 permeability)" "" ""
done
broken
finish
