#!/usr/bin/env bash
# frana check of a small image: what it says, its pictures, and what is left out where the run is too large.
# shellcheck source=tests/program/common.sh
. "$(dirname "$0")/common.sh" "$@"
# 8 x 8 x 8 voxels: four layers of solid, a layer of pore, a lone voxel of solid in the last layer
{
  head -c 256 /dev/zero | tr '\0' '\1'
  head -c 255 /dev/zero
  printf '\1'
} >sample.raw
cat >scene.yaml <<'YAML'
title: An image
domain: {size: [0.008, 0.008, 0.008]}
solid:
  spacing: 1.0e-3
  materials: [{name: quartz, youngs_modulus: 70.0e9, density: 2650}]
  bodies:
    - {name: rock, shape: image, file: sample.raw, size: [8, 8, 8], type: uint8, voxel: 1.0e-3, solid: [1],
       low: [0, 0, 0]}
stages: [{name: rest, steps: 1}]
YAML
said() { # said TEXT: the output holds it
  grep -qF -- "$1" out || fail "not said: $1"
}
for ranks in 1 2; do
  rm -rf checks
  code 0 ranks $ranks check scene.yaml
  said '8 along x, 8 along y, 8 along z, of 0.001 m; in the file x varies first, then y, then z'
  said '0      pore   255 voxels, 49.8047 %'
  said '1      solid  257 voxels, 50.1953 %'
  said 'porosity   0.49805; connected from face to face along x 0.49805, y 0.49805, z 0.00000'
  said 'pores      1 piece, the largest 100.0000 % of the pores'
  said 'solid      2 pieces, the largest 99.6109 % of the solid'
  said 'floating   1 piece of solid, 0.3891 % of it, the largest of 1 voxels: kept'
  said 'thin solid 0.3891 % of the solid is less than 3 particles wide'
  said ' 257 particles'
  for axis in x y z; do
    [ "$(head -c 8 checks/scene/rock_$axis.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] ||
      fail "checks/scene/rock_$axis.png is no picture"
  done
done
code 0 ranks 1 check scene.yaml --out elsewhere/deep --set 'solid.bodies[0].floating=remove'
said 'voxels: removed'
said ' 256 particles'
[ -s elsewhere/deep/rock_x.png ] || fail "no picture in --out"
# a header that names a unit and another size
printf 'NDims = 3\nDimSize = 8 8 8\nElementType = MET_UCHAR\nDistanceUnits = um\nElementSpacing = 500 500 500\n%s\n' \
  'ElementDataFile = sample.raw' >unit.mhd
for words in check "run --out unit"; do
  # shellcheck disable=SC2086 # words
  code 0 ranks 2 ${words%% *} scene.yaml ${words#"${words%% *}"} --set 'solid.bodies[0].file=unit.mhd'
  grep -q 'the header of .*unit.mhd says voxels of 0.0005 m along x, and solid.bodies\[0\].voxel is 0.001 m' out ||
    { cat out; fail "frana $words does not warn of the header's voxel"; }
done
# what the set-up says, before there is a run folder, is in the log too
grep -q '^rock: 1 floating piece of solid in 1 of 257 voxels' unit/run.log || fail "the log does not say what floats"
# without the scene's, the header's counts; without both, one sentence
sed 's/ voxel: 1.0e-3,//' scene.yaml >header.yaml
code 0 ranks 1 check header.yaml --set 'solid.bodies[0].file=unit.mhd' --set solid.spacing=2.5e-4
said '8 along x, 8 along y, 8 along z, of 0.0005 m'
code 2 ranks 1 check header.yaml
grep -qF 'solid.bodies[0].voxel: missing (m): the file does not give the size of its voxels with a unit' err ||
  { cat err; fail "no word on the voxel that is missing"; }
# a sample whose pores do not meet across z, between periodic sides of a flow; mirrored they do
sed -e 's/domain: .*/domain: {size: [0.008, 0.008, 0.008], cells: [8, 8, 8]}/' -e '/^solid/i\
fluid:\
  density: 1000\
  viscosity: 1.0e-3\
  sides:\
    {x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: periodic}, y_high: {type: periodic},\
     z_low: {type: periodic}, z_high: {type: periodic}}
' scene.yaml >flow.yaml
for ranks in 1 2; do
  code 0 ranks $ranks check flow.yaml
  said 'warning: across the periodic sides of z only 0 % of the pores'
  [ "$(grep -c 'across the periodic sides' out)" = 1 ] || fail "x and y are said to be shut: $(cat out)"
done
mv out checked
code 0 ranks 1 check flow.yaml --set solid.bodies.0.mirror=z \
  --set domain='{size: [0.008, 0.008, 0.016], cells: [8, 8, 16]}'
! grep -q 'across the periodic sides' out || fail "a mirrored sample is said to be shut: $(cat out)"
# frana run says it in its log, in the same words
sed -n 's/^  warning: \(across the periodic .*\)/\1/p' checked >want
code 0 ranks 2 run flow.yaml --out flow --quiet --set stages.0.solid=rigid
[ "$(grep -c 'across the periodic sides' flow/run.log)" = 1 ] || fail "the log does not say once what is shut"
grep -qF "warning: $(cat want)" flow/run.log || fail "the log has other words than frana check"
code 0 ranks 1 run flow.yaml --out whole --quiet --set stages.0.solid=rigid --set solid.bodies.0.mirror=z \
  --set domain='{size: [0.008, 0.008, 0.016], cells: [8, 8, 16]}'
! grep -q 'across the periodic sides' whole/run.log || fail "the log says that a mirrored sample is shut"
# more than 64 sites along the edge of a voxel
code 2 ranks 1 check scene.yaml --set 'solid.bodies[0].voxel=1.0e-1'
