#!/usr/bin/env bash
# Runs a scene of this folder with the default load and the settings that cost least for their error
# (cases/verification/cost): one projection a step, bonds in mixed precision, the fluid by Adams and Bashforth's scheme
# where the block is elastic, and the block settles with twice the step.
# usage: cases/porous_channel/economical.sh [RANKS [OUT [SCENE]]]      (2, runs/porous_channel/economical, s3)
set -euo pipefail
cd "$(dirname "$0")/../.."
n=${1:-2} out=${2:-runs/porous_channel/economical} scene=${3:-s3}
. cases/common.sh
settings=(coupling.load=reaction stages.settle.damping_relative=0 stages.fracture.damping_relative=0
  fluid.projection=last_stage solid.precision=mixed stages.settle.steps=2500 stages.settle.time_step=6.7138e-5
  stages.settle.fluid_integrator=ab2 stages.fracture.fluid_integrator=ab2)
mpiexec -n "$n" build/frana run "cases/porous_channel/$scene.yaml" --out "$out" "${settings[@]/#/--set=}"
